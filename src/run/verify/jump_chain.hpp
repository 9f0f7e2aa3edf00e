#pragma once
// The law of a Markov chain on 0, 1, ..., N at a time, from its rates (uniformisation: Jensen 1953): what samplers are
// judged against, made without any of them.
#include <cstddef>
#include <functional>
#include <vector>

namespace shmoo::run::verify {

struct ChainJump {
  std::size_t from = 0, to = 0;
  double rate = 0;  // [1/s]
};

// Probabilities of all states at time t [s], from a start in state `start`. States that jumps lead beyond are left out.
std::vector<double> chain_law(std::size_t states, const std::vector<ChainJump>& jumps, std::size_t start, double t);

// The stationary law of a chain of single steps, from detailed balance: up(n) leads to n + 1, down(n) to n - 1.
std::vector<double> balanced_law(std::size_t states, const std::function<double(double)>& up,
                                 const std::function<double(double)>& down);

// The probability that numbers drawn from `law` lie further from it than `numbers` do (chi-square; cells that expect
// fewer than five are joined with their neighbours).
double chance_of(const std::vector<double>& law, const std::vector<std::size_t>& numbers);

}  // namespace shmoo::run::verify
