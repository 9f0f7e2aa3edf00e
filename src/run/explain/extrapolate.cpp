// From the course of a part to the cost of the whole.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "run/explain/forecast.hpp"

namespace shmoo::run {
namespace {

// Seconds per fraction as a straight line over the fraction, by least squares over the intervals, each as heavy as it
// lasts. Intervals that list jumps anew come first and are left out.
struct Line {
  double level = 0, slope = 0, middle = 0;  // level at the middle
  double at(double fraction) const { return level + slope * (fraction - middle); }
};

constexpr std::size_t first_pure = 2;

Line fit(const std::vector<Moment>& moments) {
  Line line;
  double weight = 0, seconds = 0;
  const auto each = [&](auto&& visit) {
    for (std::size_t k = first_pure; k < moments.size(); ++k) {
      const double df = moments[k].fraction - moments[k - 1].fraction;
      visit(df, 0.5 * (moments[k].fraction + moments[k - 1].fraction), moments[k].seconds - moments[k - 1].seconds);
    }
  };
  each([&](double df, double middle, double dt) {
    weight += df;
    seconds += dt;
    line.middle += df * middle;
  });
  line.middle /= weight;
  line.level = seconds / weight;
  double above = 0, below = 0;
  each([&](double df, double middle, double dt) {
    above += (middle - line.middle) * (dt - line.level * df);
    below += df * (middle - line.middle) * (middle - line.middle);
  });
  line.slope = below > 0.0 ? above / below : 0.0;
  return line;
}

// The integral of a course told in equal parts of the whole.
double integral(const std::vector<double>& course, double from, double to) {
  const double parts = double(course.size());
  double sum = 0.0;
  for (std::size_t k = 0; k < course.size(); ++k) {
    const double overlap = std::min(to, double(k + 1) / parts) - std::max(from, double(k) / parts);
    if (overlap > 0.0) sum += overlap * course[k];
  }
  return sum;
}

// Where it is foretold how busy the run will be: as long for each event as in the part that was seen.
std::optional<Course> by_activity(const Rehearsal& rehearsal) {
  const auto& moments = rehearsal.realised;
  const std::size_t begin = moments.size() > first_pure ? first_pure - 1 : 0;  // of what is seen to be pure
  const Moment pure = moments.size() > 1 ? moments[begin] : Moment{};
  const double seen = integral(rehearsal.activity, pure.fraction, moments.back().fraction);
  if (!(seen > 0.0)) return {};
  const double an_event = (moments.back().seconds - pure.seconds) / seen;
  Course course;
  course.standing_once = std::max(0.0, pure.seconds - an_event * integral(rehearsal.activity, 0.0, pure.fraction));
  course.each = an_event * integral(rehearsal.activity, 0.0, 1.0) + rehearsal.closing_seconds;
  return course;
}

constexpr double enough_to_see_a_slope = 0.15;  // of the whole; less would tell chance
constexpr double most_change = 4.0;             // of the pace

}  // namespace

Course extrapolate(const Rehearsal& rehearsal, double until_even) {
  const auto& moments = rehearsal.realised;
  if (moments.empty()) return {rehearsal.closing_seconds};
  if (!rehearsal.others.empty())
    return {std::accumulate(rehearsal.others.begin(), rehearsal.others.end(), 0.0) / double(rehearsal.others.size())};
  if (const auto course = by_activity(rehearsal)) return *course;
  const double told = moments.back().seconds, from = moments.back().fraction;
  if (rehearsal.finished || moments.size() < first_pure + 2) return {(told + rehearsal.closing_seconds) / from};
  Line line = fit(moments);
  if (from < enough_to_see_a_slope) line.slope = 0.0;
  const double even = std::clamp(until_even, from, 1.0);
  const auto pace = [&](double fraction) {
    return std::clamp(line.at(fraction), line.level / most_change, line.level * most_change);
  };
  Course course;
  course.moving_once = std::max(0.0, moments[0].seconds - pace(0.0) * moments[0].fraction);
  course.standing_once =
      std::max(0.0, moments[1].seconds - moments[0].seconds - pace(0.0) * (moments[1].fraction - moments[0].fraction));
  course.each = told - course.moving_once - course.standing_once + 0.5 * (pace(from) + pace(even)) * (even - from) +
                pace(even) * (1.0 - even) + rehearsal.closing_seconds;
  return course;
}

}  // namespace shmoo::run
