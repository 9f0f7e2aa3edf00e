#include "hydro/effects/sponge.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace shmoo::hydro {
namespace {

// Where none is given: a tenth of the time to cross the zone, but short enough that the friction of a channel's walls
// over its whole length holds the flow back by no more than 0.5 % (plane channel of width w: deceleration 12 nu v/w^2).
template <int D>
double derive_relaxation_time(const scene::Scene& scene, const Scales<D>& scales, const scene::Inflow& inflow,
                              double time) {
  const auto& zone = std::get<scene::BoxShape>(inflow.zone->form);
  std::size_t axis = 0;
  for (std::size_t a = 1; a < D; ++a) {
    if (std::abs((*inflow.velocity)[a]) > std::abs((*inflow.velocity)[axis])) axis = a;
  }
  const double share = (zone.upper[axis] - zone.lower[axis]) / (scene.domain.upper[axis] - scene.domain.lower[axis]);
  for (std::size_t a = 0; a < D; ++a) {
    if (a == axis || scene.domain.sides[a][0].type == scene::SideType::periodic) continue;
    const double width = scene.domain.upper[a] - scene.domain.lower[a];
    if (scales.viscosity > 0.0)
      time = std::min(time, 0.005 * share * width * width / (12.0 * scales.kinematic_viscosity()));
  }
  return time;
}

}  // namespace

template <int D>
Sponge<D>::Sponge(const scene::Inflow& inflow, double relaxation_time, double viscosity)
    : inflow_(inflow), zone_(inflow_, viscosity, D), relaxation_time_(relaxation_time) {
  for (int a = 0; a < D; ++a) target_[a] = (*inflow.velocity)[std::size_t(a)];
}

template <int D>
void Sponge<D>::choose(const scene::Scene& scene, const Scales<D>& scales, BodyEffects<D>& list) {
  const double nu = scales.viscosity > 0.0 ? scales.kinematic_viscosity() : scales.sound_speed * scales.smoothing;
  for (const auto& inflow : scene.inflows) {
    if (!inflow.velocity) continue;
    if (!inflow.zone || !std::holds_alternative<scene::BoxShape>(inflow.zone->form)) {
      throw base::InputError("an inflow's zone must be a box; give its lower and upper end on each axis");
    }
    double time = sph::Sponge(inflow, nu, D).relaxation_time();
    if (!inflow.relaxation_time) time = derive_relaxation_time<D>(scene, scales, inflow, time);
    list.push_back(std::make_unique<Sponge>(inflow, time, nu));
  }
}

template <int D>
void Sponge<D>::describe(std::vector<Derived>& list) const {
  list.push_back({"sponge relaxation time of velocity", relaxation_time_, "s",
                  inflow_.relaxation_time
                      ? "as given"
                      : "a tenth of the zone's crossing time, or less so that wall friction holds the "
                        "flow back by at most 0.5 %"});
}

template <int D>
void Sponge<D>::apply(const BodyView<D>& view, std::span<const std::uint32_t> particles) const {
  for (const std::uint32_t i : particles) {
    scene::Point x{};
    for (int a = 0; a < D; ++a) x[std::size_t(a)] = view.position[i][a];
    const double phi = zone_.rate(x) * zone_.relaxation_time();
    if (!(phi > 0.0)) continue;
    const double rate = -std::expm1(-phi * view.dt / relaxation_time_) / view.dt;  // [1/s]
    view.acceleration[i] -= rate * (view.velocity[i] - target_);
  }
}

template class Sponge<2>;
template class Sponge<3>;

}  // namespace shmoo::hydro
