#include "rdme/time/timed_rate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rdme/time/steps_of.hpp"

namespace shmoo::rdme {
namespace {

constexpr int parts = 8;  // of a stretch that is looked at
constexpr int deepest = 8;

double at(Expression& expression, double t) {
  expression.set_time(t);
  return expression.value();
}

double between(double from, double to, int k) { return k == parts ? to : from + (to - from) * k / parts; }

}  // namespace

TimedRate::TimedRate(const std::string& text, const ExpressionNames& names) : rate_(text, names) {
  for (const StepSource& source : steps_of(text)) {
    Step step{Expression(source.level, names), Expression(source.distance, names)};
    if (!step.level.reads_time()) continue;
    const bool local = !step.level.reads().empty() || step.level.reads_place();
    (local ? local_ : common_).push_back(std::move(step));
  }
}

double TimedRate::bound(double from, double to) {
  if (local_.empty()) return smooth_bound(from, to);
  std::vector<double> moments;
  find(local_, from, to, moments);
  std::ranges::sort(moments);
  double most = 0.0;
  for (const double moment : moments) {
    const double before = smooth_bound(from, std::nextafter(moment, from));
    if (!(before >= 0.0 && std::isfinite(before))) return before;
    most = std::max(most, before);
    from = moment;
  }
  const double last = smooth_bound(from, to);
  return last >= 0.0 ? std::max(most, last) : last;
}

double TimedRate::smooth_bound(double from, double to) {
  double most = 0.0, change = 0.0, before = 0.0;
  for (int k = 0; k <= parts; ++k) {
    const double value = at(between(from, to, k));
    if (!(value >= 0.0 && std::isfinite(value))) return value;
    most = std::max(most, value);
    if (k > 0) change = std::max(change, std::abs(value - before));
    before = value;
  }
  return most + 2.0 * change;
}

void TimedRate::find(std::vector<Step>& steps, double from, double to, std::vector<double>& moments) {
  for (Step& step : steps) find(step, from, to, 0, moments);
}

// Where the distance is small against its change from one look to the next, it may be zero in between: look closer.
void TimedRate::find(Step& step, double from, double to, int depth, std::vector<double>& moments) {
  std::array<double, parts + 1> distance;
  double change = 0.0;
  for (std::size_t k = 0; k <= parts; ++k) {
    distance[k] = rdme::at(step.distance, between(from, to, int(k)));
    if (k > 0) change = std::max(change, std::abs(distance[k] - distance[k - 1]));
  }
  for (int k = 0; k < parts; ++k) {
    double low = between(from, to, k), high = between(from, to, k + 1);
    const double level = rdme::at(step.level, low);
    if (rdme::at(step.level, high) == level) {
      const double near = std::min(std::abs(distance[std::size_t(k)]), std::abs(distance[std::size_t(k) + 1]));
      if (near < change && depth < deepest && low < high) find(step, low, high, depth + 1, moments);
      continue;
    }
    for (double middle = low; (middle = low + 0.5 * (high - low)) > low && middle < high;)
      (rdme::at(step.level, middle) == level ? low : high) = middle;
    moments.push_back(high);
    if (depth < deepest && high < between(from, to, k + 1))
      find(step, high, between(from, to, k + 1), depth + 1, moments);
  }
}

}  // namespace shmoo::rdme
