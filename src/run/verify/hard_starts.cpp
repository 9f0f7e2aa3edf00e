#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

const std::string box = square("0.04 m", "0.01 Pa s", periodic, vortices);

// Whatever the arrangement, stirring must spread the particles out and viscosity bring them to rest; the first time
// unit, a crossing of the box, may be lively.
std::vector<Finding> comes_to_rest(hydro::Fluid<2>& fluid) {
  const auto seen = watch(fluid, 10.0, 100, 1.0);
  const double momentum = fluid.momentum().norm() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
  return {at_most("fastest particle ever, in speeds of the vortices", seen.speed, 2.0),
          at_most("kinetic energy at the end, of the largest", seen.final_energy, 1e-4),
          at_most("largest rise of kinetic energy from t = 1 on", seen.energy_rise, 1e-3),
          at_least("smallest distance from t = 1 on, in spacings", seen.distance, 0.5),
          at_most("density error from t = 1 on", seen.density_error, 0.05),
          at_most("mean velocity at the end", momentum, 1e-2)};
}

std::vector<Finding> disordered() {
  const auto scene = scene_of(box, {{"domain.jitter", "0.5"}});
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  return comes_to_rest(fluid);
}

// Along x particles are squeezed together by up to two and drawn apart by up to a half.
std::vector<Finding> clustered() {
  const auto scene = scene_of(box);
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  for (auto& x : fluid.particles().position.values())
    x[0] += 0.5 / 6.283185307179586 * std::sin(6.283185307179586 * x[0]);
  fluid.restart();
  return comes_to_rest(fluid);
}

// Every fifth particle stands a millionth of a spacing beside its neighbour.
std::vector<Finding> almost_coincident() {
  const auto scene = scene_of(box);
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  auto& particles = fluid.particles();
  std::vector<base::Vec<2>> by_id(particles.size());
  for (std::size_t i = 0; i < particles.size(); ++i) by_id[particles.id[i]] = particles.position[i];
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.id[i] % 5 == 1) particles.position[i] = by_id[particles.id[i] - 1] + base::Vec<2>(4e-8, 2e-8);
  }
  fluid.restart();
  return comes_to_rest(fluid);
}

// One particle between four walls, pulled down.
std::vector<Finding> one_particle() {
  const auto scene = scene_of(R"toml(
title = "One particle in a box"
dimension = 2
depth = "1 m"
[domain]
size = ["0.1 m", "0.1 m"]
spacing = "0.1 m"
boundary = { x = "wall", y = "wall" }
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.1 Pa s"
[flow]
body_force = ["0 m/s^2", "-1 m/s^2"]
[run]
until = "20 s"
record_every = "20 s"
)toml");
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const auto seen = watch(fluid, 20.0, 200);
  return {exactly("particles", double(fluid.state().rows.fluid().size()), 1.0),
          exactly("particles outside", seen.outside, 0.0),
          at_most("speed at the end, in speeds of sound", fluid.max_speed() / fluid.scales().sound_speed, 1e-2)};
}

}  // namespace

std::vector<Case> hard_starts() {
  return {{"disordered", "particles start up to half a spacing off their places", disordered},
          {"clustered", "particles start twice as dense here as there", clustered},
          {"almost-coincident", "every fifth particle starts a millionth of a spacing from another", almost_coincident},
          {"one-particle", "a flow of one particle between walls", one_particle}};
}

}  // namespace shmoo::run::verify
