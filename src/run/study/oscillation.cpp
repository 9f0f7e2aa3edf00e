#include "run/study/oscillation.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace shmoo::run {
namespace {

constexpr int oversampling = 10;  // frequencies tried within the width of a peak

struct Fit {
  double amplitude, rest;  // rest: sum of squares that the fit leaves
};

Fit fit(std::span<const double> time, std::span<const double> value, double frequency) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double phase = 2.0 * std::numbers::pi * frequency * (time[k] - time[0]);
    const Eigen::Vector3d base(1.0, std::cos(phase), std::sin(phase));
    normal += base * base.transpose();
    right += value[k] * base;
    squares += value[k] * value[k];
  }
  const Eigen::Vector3d solution = normal.ldlt().solve(right);
  return {std::hypot(solution[1], solution[2]), squares - solution.dot(right)};
}

}  // namespace

double half_range(std::span<const double> value) {
  const auto [low, high] = std::minmax_element(value.begin(), value.end());
  return 0.5 * (*high - *low);
}

double first_period(std::span<const double> time, std::span<const double> value) {
  const auto [low, high] = std::minmax_element(value.begin(), value.end());
  const double middle = 0.5 * (*low + *high);
  std::array<std::vector<double>, 2> crossing;  // downwards, upwards
  for (std::size_t t = 1; t < time.size(); ++t) {
    const double before = value[t - 1] - middle, after = value[t] - middle;
    if ((before < 0.0) == (after < 0.0)) continue;
    crossing[before < 0.0].push_back(time[t - 1] + (time[t] - time[t - 1]) * before / (before - after));
  }
  double period = std::numeric_limits<double>::infinity(), begin = period;
  for (const auto& way : crossing) {
    if (way.size() < 2 || way[0] > begin) continue;
    begin = way[0];
    period = way[1] - way[0];
  }
  return period;
}

Harmonic strongest_harmonic(std::span<const double> time, std::span<const double> value) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (time.size() < 4) return {none, none};
  const double length = time.back() - time.front(), lowest = 1.0 / length;
  const double step = lowest / oversampling, highest = 0.5 * double(time.size() - 1) * lowest;
  const auto rest = [&](double frequency) { return fit(time, value, frequency).rest; };
  double best = lowest;
  double least = rest(best);
  for (int k = oversampling + 1; step * k < highest; ++k) {
    const double now = rest(step * k);
    if (!(now < least)) continue;
    least = now;
    best = step * k;
  }
  const auto found = boost::math::tools::brent_find_minima(rest, best - step, best + step, 40);
  return {fit(time, value, found.first).amplitude, 1.0 / found.first};
}

}  // namespace shmoo::run
