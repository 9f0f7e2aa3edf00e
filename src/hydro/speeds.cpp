#include "hydro/speeds.hpp"

#include <algorithm>
#include <cmath>

#include "hydro/extents.hpp"
#include "hydro/initial_velocity.hpp"
#include "hydro/open/opening.hpp"
#include "hydro/wall_motion.hpp"

namespace shmoo::hydro {
namespace {

// The speed to which a body force drives the fluid: the laminar channel's f L^2/(8 nu) where it acts along periodic
// axes between walls, else that of a free fall over the domain.
template <int D>
double force_speed(const scene::Scene& scene, const Scales<D>& scales) {
  double along_periodic = 0.0, fall = 0.0;
  bool walls = false;
  for (int a = 0; a < D; ++a) fall += scales.lightness * std::abs(scales.gravity[a]) * extent(scene, a);
  for (int a = 0; a < D; ++a) {
    walls = walls || has_friction(scene, a);
    if (passes(scene, a))
      along_periodic += std::abs(scales.body_force[a]);
    else
      fall += std::abs(scales.body_force[a]) * extent(scene, a);
  }
  const double nu = scales.kinematic_viscosity();
  const double free = std::sqrt(2.0 * along_periodic * scales.length);
  const double channel = walls && nu > 0.0 ? along_periodic * scales.length * scales.length / (8.0 * nu) : free;
  return std::max(channel, std::sqrt(2.0 * fall));
}

// The speed that the pressures of open sides drive: the laminar channel's dp w^2/(8 eta l) where there are walls, but
// no more than that of fluid that nothing holds back.
template <int D>
double pressure_speed(const scene::Scene& scene, const Scales<D>& scales) {
  const double drop = held_pressure_drop(scene);
  double speed = std::sqrt(2.0 * drop / scales.density);
  for (int along = 0; along < D; ++along) {
    const auto& sides = scene.domain.sides[std::size_t(along)];
    if (!scene::is_open(sides[0].type) || !scene::is_open(sides[1].type) || !(scales.viscosity > 0.0)) continue;
    for (int across = 0; across < D; ++across) {
      const double w = extent(scene, across);
      if (across == along || !has_friction(scene, across)) continue;
      speed = std::min(speed, drop * w * w / (8.0 * scales.viscosity * extent(scene, along)));
    }
  }
  return speed;
}

// What an elastic solid starts with, and what it reaches in falling through the domain.
template <int D, class Offer>
void offer_solid(const scene::Material& material, const scene::Scene& scene, const sph::Filling<D>& filling,
                 const Offer& offer) {
  if (!material.elastic) return;
  const auto index = std::uint16_t(&material - scene.materials.data());
  const InitialVelocity<D> initial(material.elastic->initial_velocity, scene.parameters);
  for (std::size_t i = 0; i < filling.voxels; ++i)
    if (filling.particles.material[i] == index)
      offer(initial(filling.particles.position[i]).norm(), "largest initial velocity of a solid");
  double fall = 0.0;
  for (int a = 0; a < D; ++a) fall += std::abs(material.elastic->body_force[std::size_t(a)]) * extent(scene, a);
  offer(std::sqrt(2.0 * fall), "free fall of a solid through the domain");
}

}  // namespace

template <int D>
SpeedCandidate largest_speed(const scene::Scene& scene, const sph::Filling<D>& filling, const Scales<D>& scales) {
  SpeedCandidate best{0.0, "nothing moves"};
  const auto offer = [&](double speed, const char* why) {
    if (speed > best.speed) best = {speed, why};
  };
  if (scales.thermal_energy > 0.0) {
    offer(std::sqrt(D * scales.thermal_energy / scales.mass), "thermal velocity sqrt(D kT/m)");
  }
  if (scene.flow.reference_speed) {  // no noise survives a sound slower than the thermal velocity
    offer(*scene.flow.reference_speed, "flow.reference_speed");
    return best;
  }
  for (const auto& inflow : scene.inflows) {
    if (inflow.velocity) offer(vector_of<D>(*inflow.velocity).norm(), "largest inflow velocity");
  }
  offer(fastest_inflow<D>(scene, filling), "largest velocity of an inlet");
  offer(pressure_speed<D>(scene, scales), "speed that the pressures of open sides drive");
  const WallMotion<D> motion(scene);
  for (std::size_t i = 0; i < filling.particles.size(); ++i) {
    if (filling.particles.role[i] == sph::Role::fluid || filling.particles.role[i] == sph::Role::open) continue;
    offer(motion.surface_velocity(filling.particles.material[i], filling.particles.position[i], 0.0).norm(),
          "largest wall velocity");
  }
  const InitialVelocity<D> initial(scene);
  for (std::size_t i = 0; i < filling.voxels; ++i) {
    if (filling.particles.role[i] != sph::Role::fluid) continue;
    offer(initial(filling.particles.position[i]).norm(), "largest initial velocity");
  }
  for (const auto& material : scene.materials) offer_solid<D>(material, scene, filling, offer);
  offer(force_speed<D>(scene, scales), "speed that body force and buoyancy drive");
  return best;
}

template SpeedCandidate largest_speed(const scene::Scene&, const sph::Filling<2>&, const Scales<2>&);
template SpeedCandidate largest_speed(const scene::Scene&, const sph::Filling<3>&, const Scales<3>&);

}  // namespace shmoo::hydro
