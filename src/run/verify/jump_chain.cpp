#include "run/verify/jump_chain.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shmoo::run::verify {

std::vector<double> chain_law(std::size_t states, const std::vector<ChainJump>& jumps, std::size_t start, double t) {
  std::vector<double> leave(states, 0.0);
  for (const auto& jump : jumps) leave[jump.from] += jump.rate;
  const double fastest = *std::max_element(leave.begin(), leave.end());
  std::vector<double> now(states, 0.0), law(states, 0.0);
  now[start] = 1.0;
  const double mean = fastest * t;
  double log_weight = -mean, told = 0.0;  // of the Poisson law of moves
  for (std::size_t k = 0; told < 1.0 - 1e-13 && double(k) < mean + 12.0 * std::sqrt(mean) + 60.0; ++k) {
    const double weight = std::exp(log_weight);
    for (std::size_t n = 0; n < states; ++n) law[n] += weight * now[n];
    told += weight;
    log_weight += std::log(mean) - std::log(double(k + 1));
    std::vector<double> next(states);
    for (std::size_t n = 0; n < states; ++n) next[n] = now[n] * (1.0 - leave[n] / fastest);
    for (const auto& jump : jumps)
      if (jump.to < states) next[jump.to] += now[jump.from] * jump.rate / fastest;
    now = std::move(next);
  }
  return law;
}

std::vector<double> balanced_law(std::size_t states, const std::function<double(double)>& up,
                                 const std::function<double(double)>& down) {
  std::vector<double> log_law(states, 0.0);
  for (std::size_t n = 1; n < states; ++n)
    log_law[n] = log_law[n - 1] + std::log(up(double(n - 1))) - std::log(down(double(n)));
  const double largest = *std::max_element(log_law.begin(), log_law.end());
  std::vector<double> law;
  for (const double value : log_law) law.push_back(std::exp(value - largest));
  const double sum = std::accumulate(law.begin(), law.end(), 0.0);
  for (double& p : law) p /= sum;
  return law;
}

double chance_of(const std::vector<double>& law, const std::vector<std::size_t>& numbers) {
  std::vector<double> seen(law.size(), 0.0);
  for (const std::size_t n : numbers) {
    if (n >= law.size()) return 0.0;
    ++seen[n];
  }
  const double total = double(numbers.size());
  double chi2 = 0.0, expected = 0.0, counted = 0.0, rest = total;
  std::size_t cells = 0;
  for (std::size_t n = 0; n < law.size(); ++n) {
    expected += total * law[n];
    counted += seen[n];
    const bool last = n + 1 == law.size();
    if (!last && (expected < 5.0 || rest - expected < 5.0)) continue;  // what is left joins the last cell
    if (expected > 0.0) {
      chi2 += (counted - expected) * (counted - expected) / expected;
      ++cells;
    }
    rest -= expected;
    expected = counted = 0.0;
  }
  return cells > 1 ? gsl_cdf_chisq_Q(chi2, double(cells - 1)) : 1.0;
}

}  // namespace shmoo::run::verify
