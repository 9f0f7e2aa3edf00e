#include "run/bench/problem.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "run/bench/lattice_problem.hpp"

namespace shmoo::run::bench {

double spread_over_voxels(const Numbers& numbers) {
  double chi2 = 0.0;
  for (std::size_t s = 0; s < numbers.species; ++s) {
    const double mean = numbers.total(s) / double(numbers.voxels());
    for (std::size_t i = s; i < numbers.n.size(); i += numbers.species)
      chi2 += (numbers.n[i] - mean) * (numbers.n[i] - mean) / mean;
  }
  const double degrees = double(numbers.species * (numbers.voxels() - 1));
  return (chi2 - degrees) / std::sqrt(2.0 * degrees);
}

namespace {

// All species of the ring are equal: multinomial over them as over voxels.
double spread_over_species(const Numbers& numbers) { return spread_over_voxels({numbers.n, 1}); }

// At equilibrium (T_A - C)(T_B - C)/N = mean C with the conserved totals; the variance of C given them is that of
// three Poisson numbers on the line that keeps both: 1/(1/A + 1/B + 1/C).
double distance_from_equilibrium(const Numbers& numbers, double mean) {
  const double A = numbers.total(0), B = numbers.total(1), C = numbers.total(2), N = double(numbers.voxels());
  const double a = A + C, b = B + C, sum = a + b + mean * N;
  const double wanted = 0.5 * (sum - std::sqrt(sum * sum - 4.0 * a * b));
  const double variance = 1.0 / (1.0 / (a - wanted) + 1.0 / (b - wanted) + 1.0 / wanted);
  return (C - wanted) / std::sqrt(variance);
}

constexpr double dimers = 0.01;  // K = k/back of 2 M <-> D

// M where K M^2 = D.
double free_at_equilibrium(const Numbers& numbers) {
  const double total = numbers.n[1] + 2.0 * numbers.n[0];
  return (std::sqrt(1.0 + 8.0 * dimers * total) - 1.0) / (4.0 * dimers);
}

// 2 M <-> D at equal numbers: the mean of M at equilibrium from mass action, its variance from detailed balance,
// P(D) ~ K^D/(M! D!): 4 M D/(M + 4 D).
double dimer_deviation(const Numbers& numbers) {
  const double m = free_at_equilibrium(numbers), d = 0.5 * (numbers.n[1] + 2.0 * numbers.n[0] - m);
  return (numbers.n[1] - m) / std::sqrt(4.0 * m * d / (m + 4.0 * d));
}

// A wave along x on n cells, of amplitude a half.
double wave(std::uint32_t n, std::size_t voxel) {
  return 0.5 * std::cos(2.0 * std::numbers::pi * (double(voxel % n) + 0.5) / n);
}

}  // namespace

double Numbers::total(std::size_t s) const {
  double sum = 0.0;
  for (std::size_t i = s; i < n.size(); i += species) sum += n[i];
  return sum;
}

Numbers counts_of(const rdme::State& state) { return {{state.count.begin(), state.count.end()}, state.species}; }
Numbers amounts_of(const rdme::State& state) { return {state.amount, state.species}; }

// The wave decays as exp(-2 (1 - cos(2 pi/n)) t).
Problem diffusion_problem(std::uint32_t n) {
  Problem problem;
  problem.name = fmt::format("D3-{}", n);
  problem.scene = diffusion_scene();
  problem.cells = {n, n, n};
  problem.events_per_second = 60.0 * problem.voxels();
  problem.law = "multinomial over the voxels";
  problem.deviations = spread_over_voxels;
  problem.start = [n](Numbers& numbers) {
    for (std::size_t i = 0; i < numbers.n.size(); ++i) numbers.n[i] = 10.0 * (1.0 + wave(n, i));
  };
  problem.smooth_law = "decay of a wave";
  problem.error = [n](const Numbers& numbers) {
    const double decay = std::exp(-2.0 * (1.0 - std::cos(2.0 * std::numbers::pi / n)));
    double off = 0.0;
    for (std::size_t i = 0; i < numbers.n.size(); ++i)
      off = std::max(off, std::abs(numbers.n[i] - 10.0 * (1.0 + decay * wave(n, i))));
    return off / 10.0;
  };
  return problem;
}

// Without noise from scattered numbers for a second, by which reactions are done: A B = mean C in each voxel but for
// what gradients still carry.
Problem binding_problem(std::uint32_t n, double mean) {
  Problem problem;
  problem.name = fmt::format("RD-{}", n);
  problem.scene = binding_scene(mean);
  problem.mean = mean;
  problem.cells = {n, n, n};
  problem.events_per_second = 36.0 * mean * problem.voxels();
  problem.law = problem.smooth_law = "A + B <-> C in equilibrium";
  problem.deviations = [mean](const Numbers& numbers) { return distance_from_equilibrium(numbers, mean); };
  problem.start = [](Numbers&) {};
  problem.error = [mean](const Numbers& numbers) {
    double forward = 0.0, backward = 0.0;
    for (std::size_t i = 0; i < numbers.n.size(); i += 3) {
      forward += 9.0 / mean * numbers.n[i] * numbers.n[i + 1];
      backward += 9.0 * numbers.n[i + 2];
    }
    return forward / backward - 1.0;
  };
  return problem;
}

// Without noise from all in the first species for a time of 2: Poisson numbers of steps around the ring.
Problem ring_problem(int species) {
  Problem problem;
  problem.name = fmt::format("ring-{}", species);
  problem.scene = ring_scene(species);
  problem.mean = 1000.0;
  problem.events_per_second = 1000.0 * species;
  problem.law = "multinomial over the species";
  problem.deviations = spread_over_species;
  problem.start = [](Numbers& numbers) {
    std::ranges::fill(numbers.n, 0.0);
    numbers.n[0] = 1000.0;
  };
  problem.until = 2.0;
  problem.smooth_law = "Poisson numbers of steps";
  problem.error = [](const Numbers& numbers) {
    std::vector<double> law(numbers.n.size(), 0.0);
    for (int k = 0; k < 60; ++k)
      law[std::size_t(k) % law.size()] += 1000.0 * std::exp(k * std::log(2.0) - 2.0 - std::lgamma(k + 1.0));
    double off = 0.0;
    for (std::size_t s = 0; s < law.size(); ++s) off = std::max(off, std::abs(numbers.n[s] - law[s]));
    return off / 1000.0;
  };
  return problem;
}

Problem dimer_problem() {
  Problem problem;
  problem.name = "dimer";
  problem.scene = dimer_scene(dimers, 1.0);
  problem.mean = 1e5 / 3.0;
  problem.events_per_second = 1e5;
  problem.law = problem.smooth_law = "2 M <-> D in equilibrium";
  problem.deviations = dimer_deviation;
  problem.start = [](Numbers&) {};
  problem.error = [](const Numbers& numbers) { return numbers.n[1] / free_at_equilibrium(numbers) - 1.0; };
  return problem;
}

}  // namespace shmoo::run::bench
