#include "coupling/schedule.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::coupling {

std::vector<double> record_times(const scene::Run& run) {
  std::vector<double> times{0.0, run.until};
  const auto whole = static_cast<std::size_t>(std::floor(run.until / run.record_every * (1.0 + 1e-12)));
  for (std::size_t k = 1; k <= whole; ++k) times.push_back(static_cast<double>(k) * run.record_every);
  times.insert(times.end(), run.record_at.begin(), run.record_at.end());
  std::sort(times.begin(), times.end());
  std::vector<double> distinct;
  for (const double t : times) {
    if (t > run.until * (1.0 + 1e-12)) continue;
    if (distinct.empty() || t - distinct.back() > 1e-9 * run.until) distinct.push_back(t);
  }
  distinct.back() = run.until;
  return distinct;
}

double interval_end(double t, double step, double target) {
  const double left = target - t;
  const double parts = std::max(1.0, std::ceil(left / step * (1.0 - 1e-9)));
  return parts == 1.0 ? target : t + left / parts;
}

}  // namespace shmoo::coupling
