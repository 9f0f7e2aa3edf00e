#include <numbers>

#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

// Particles that start on a lattice must leave it without clumping, and go on when hardly any motion is left.
std::vector<Finding> vortices_from_a_lattice() {
  const auto scene = scene_of(square("0.025 m", "0.01 Pa s", periodic, vortices));
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const double start = fluid.kinetic_energy();
  const auto early = watch(fluid, 2.0, 20);
  const double rate = -16.0 * std::numbers::pi * std::numbers::pi * 0.01;  // of kinetic energy, 2 (-8 pi^2/Re)
  const double ratio = fluid.kinetic_energy() / (start * std::exp(2.0 * rate));
  const auto late = watch(fluid, 20.0, 90);
  return {
      within("kinetic energy at t = 2 over the exact one", ratio, 0.97, 1.03),
      at_most("kinetic energy left at t = 20, of that at the start", late.final_energy * std::exp(2.0 * rate), 1e-5),
      at_most("largest rise of kinetic energy", std::max(early.energy_rise, late.energy_rise), 1e-3),
      at_least("smallest distance of particles to t = 2, in spacings", early.distance, 0.5),
      at_least("smallest distance of particles to t = 20, in spacings", late.distance, 0.7),
      at_most("largest density error", std::max(early.density_error, late.density_error), 0.03)};
}

// The velocity is singular in the corners, and the lid has its full speed in the first step.
std::vector<Finding> sudden_lid() {
  const std::string sides = R"({ x = "wall", y = "wall", y_max = { type = "wall", velocity = ["1 m/s", "0 m/s"] } })";
  const auto scene = scene_of(square("0.025 m", "0.001 Pa s", sides, ""));
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const auto seen = watch(fluid, 20.0, 200);
  return {at_most("fastest particle, in speeds of the lid", seen.speed, 1.1),
          at_most("largest density error", seen.density_error, 0.05), exactly("particles outside", seen.outside, 0.0),
          at_least("smallest distance of particles, in spacings", seen.distance, 0.3)};
}

// Thermal speeds far above anything else: the speed of sound must follow and the temperature hold.
std::vector<Finding> strong_noise() {
  const auto scene = scene_of(square("0.05 m", "0.1 Pa s", periodic, R"toml([flow]
thermal_energy = "1 J"
reference_speed = "1e-3 m/s"
[effects]
thermal_noise = true
transport_velocity = false
)toml"));
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene), {1, 0});
  fluid.advance(100 * fluid.dt());
  constexpr int looks = 2000;
  double sum = 0.0;
  for (int k = 0; k < looks; ++k) {
    for (int n = 0; n < 5; ++n) fluid.step();
    sum += fluid.temperature();
  }
  double gross = 0.0;
  for (const auto i : fluid.state().rows.fluid()) gross += fluid.scales().mass * fluid.velocity(i).norm();
  return {within("temperature over the wanted one", sum / looks / fluid.scales().thermal_energy, 0.97, 1.03),
          at_most("momentum, of sum |m v|", fluid.momentum().norm() / gross, 1e-10)};
}

// A force that nothing balances: particles outrun the step that was derived, which must shorten, and a uniform motion
// must stay one.
std::vector<Finding> runaway_force() {
  const auto scene = scene_of(square("0.1 m", "0.001 Pa s", periodic, R"toml([flow]
body_force = ["1 m/s^2", "0.5 m/s^2"]
reference_speed = "1e-2 m/s"
)toml"));
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const double first = fluid.dt();
  fluid.advance(100.0 - 0.01);
  const auto until = fluid.steps();
  fluid.advance(100.0);
  const double last = 0.01 / double(fluid.steps() - until);
  double spread = 0.0;
  const base::Vec<2> mean = fluid.momentum() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
  for (const auto i : fluid.state().rows.fluid()) spread = std::max(spread, (fluid.velocity(i) - mean).norm());
  return {at_least("first step over the last", first / last, 10.0),
          within("mean velocity over g t", mean[0] / 100.0, 1.0 - 1e-9, 1.0 + 1e-9),
          at_most("spread of velocities, of the mean", spread / mean.norm(), 1e-9)};
}

}  // namespace

std::vector<Case> hard_flows() {
  return {{"vortices", "particles leave a lattice, then hardly any motion is left", vortices_from_a_lattice},
          {"sudden-lid", "a lid at full speed in the first step, singular corners", sudden_lid},
          {"strong-noise", "thermal energy a million times that of the flow", strong_noise},
          {"runaway-force", "speeds far beyond those that the step was derived for", runaway_force}};
}

}  // namespace shmoo::run::verify
