#pragma once
// How what implicit friction costs falls while a flow that started at rest settles. Solutions begin from the last
// velocity, which changes by 1/k of itself in step k, as does the residual at first: what it must decline by,
// D = ln(first/allowed), falls as ln k. Products with the matrix go as D^2, as a smoother residual also declines
// faster (tried: 0.083 to 0.114 D^2 a step through the first 300 of yeast-gradient at 1 and 2 um), and hardly fall from
// D = 8.5 on, as particles that pass each other go on disturbing the flow (the same, and a slow channel at 50 and 100
// across).
#include <algorithm>
#include <cmath>

namespace shmoo::coupling {

struct FrictionCourse {
  static constexpr double least_decline = 8.5;

  double seconds = 0;  // CPU time of friction in a step, about step `step`
  double step = 0;     // its number
  double decline = 0;  // of the residual in one solution there, as a logarithm

  // [s] of a step in the mean over the first `steps`: falling as (1 - ln(k/step)/decline)^2, and then no longer.
  double mean(double steps) const {
    if (steps <= step || decline <= least_decline) return seconds;
    const double until = std::min(steps, step * std::exp(decline - least_decline));
    const double u = std::log(until / step), first = u - 1.0, second = u * u - 2.0 * u + 2.0;  // means of ln and ln^2
    const double falling = 1.0 - 2.0 * first / decline + second / (decline * decline);
    const double last = std::pow(1.0 - u / decline, 2);
    return seconds * (falling * until + last * (steps - until)) / steps;
  }
};

}  // namespace shmoo::coupling
