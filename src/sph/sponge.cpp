#include "sph/sponge.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::sph {

Sponge::Sponge(const scene::Inflow& inflow, double diffusivity, int dimension)
    : inflow_(inflow), dimension_(dimension) {
  const auto& zone = std::get<scene::BoxShape>(inflow.zone->form);
  const scene::Point velocity = inflow.velocity.value_or(scene::Point{});
  for (int a = 1; a < dimension; ++a) {
    if (std::abs(velocity[a]) > std::abs(velocity[axis_])) axis_ = a;
  }
  along_ = velocity[axis_] >= 0.0;
  from_ = zone.lower[axis_];
  length_ = zone.upper[axis_] - zone.lower[axis_];
  const double speed = std::abs(velocity[axis_]);
  const double crossing = speed > 0.0 ? length_ / speed : length_ * length_ / diffusivity;
  relaxation_time_ = inflow.relaxation_time.value_or(0.1 * crossing);
}

double Sponge::rate(const scene::Point& x) const {
  if (!scene::contains(*inflow_.zone, x, dimension_)) return 0.0;
  double phi = 1.0;
  if (inflow_.ramp_exponent > 0) {
    const double s = std::clamp((x[axis_] - from_) / length_, 0.0, 1.0);
    phi = std::pow(along_ ? s : 1.0 - s, inflow_.ramp_exponent);
  }
  return phi / relaxation_time_;
}

}  // namespace shmoo::sph
