#include "hydro/open/opening.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::hydro {
namespace {

constexpr int looks = 64;  // at velocities that change in time

}  // namespace

template <int D>
std::vector<Opening<D>> openings_of(const scene::Scene& scene, const sph::Filling<D>& filling) {
  std::vector<Opening<D>> openings;
  for (int a = 0; a < D; ++a) {
    for (int end = 0; end < 2; ++end) {
      const auto& side = scene.domain.sides[std::size_t(a)][std::size_t(end)];
      if (!scene::is_open(side.type)) continue;
      Opening<D> opening{.axis = a, .side = end, .velocity = {}};
      opening.plane = end == 0 ? filling.box.lower[a] : filling.box.upper[a];
      opening.depth = double(sph::layers_beyond(side.type, scene.numerics.reach)) * filling.spacing[a];
      opening.pressure = side.pressure.value_or(0.0);
      if (!side.inflow.empty()) opening.velocity.emplace(side.inflow, scene.parameters);
      openings.push_back(std::move(opening));
    }
  }
  return openings;
}

template <int D>
double fastest_inflow(const scene::Scene& scene, const sph::Filling<D>& filling) {
  const auto openings = openings_of<D>(scene, filling);
  double fastest = 0.0;
  for (const auto& opening : openings) {
    if (!opening.velocity) continue;
    for (std::size_t i = filling.voxels; i < filling.particles.size(); ++i) {
      const auto& x = filling.particles.position[i];
      if (filling.particles.role[i] != sph::Role::open || !(opening.beyond(x) > 0.0)) continue;
      for (int k = 0; k <= looks; ++k)
        fastest = std::max(fastest, (*opening.velocity)(opening.foot(x), scene.run.until * k / looks).norm());
    }
  }
  return fastest;
}

double held_pressure_drop(const scene::Scene& scene) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const auto& axis : scene.domain.sides) {
    for (const auto& side : axis) {
      if (!side.pressure) continue;
      least = std::min(least, *side.pressure);
      most = std::max(most, *side.pressure);
    }
  }
  return std::max(most - least, 0.0);
}

template struct Opening<2>;
template struct Opening<3>;
template std::vector<Opening<2>> openings_of(const scene::Scene&, const sph::Filling<2>&);
template std::vector<Opening<3>> openings_of(const scene::Scene&, const sph::Filling<3>&);
template double fastest_inflow(const scene::Scene&, const sph::Filling<2>&);
template double fastest_inflow(const scene::Scene&, const sph::Filling<3>&);

}  // namespace shmoo::hydro
