// Walls and fluids under strain: pressures far below zero, fluids that collide.
#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

using Fluid = hydro::Fluid<2>;
using base::Vec;

// Fluid that is torn apart: the pressure falls far below zero, where particles attract and clump.
std::vector<Finding> stretched_patch() {
  const auto scene = scene_of(square("0.025 m", "0.01 Pa s", periodic, R"toml([parameters]
U = "3 m/s"
k = "6.283185307179586 1/m"
[flow]
initial_velocity = ["-U * sin(k*x)*cos(k*y)", "U * cos(k*x)*sin(k*y)"]
reference_speed = "3 m/s"
)toml"));
  Fluid fluid(scene, sph::fill<2>(scene));
  double lowest = 0.0, distance = 1.0;
  for (int look = 0; look < 100; ++look) {
    fluid.advance(0.01 * (look + 1));
    for (const std::uint32_t i : fluid.state().rows.fluid()) lowest = std::min(lowest, fluid.state().pressure[i]);
    distance = std::min(distance, fluid.smallest_distance());
  }
  return {at_most("lowest pressure, in rho U^2", lowest / 9.0, -0.1),
          at_least("smallest distance of particles, in spacings", distance, 0.5),
          at_most("largest density error", fluid.density_error(), 0.03)};
}

// Two halves of a fluid run into each other at the speed of sound: shocks, and behind them a tear.
scene::Scene collision(const scene::Overrides& overrides = {}) {
  return scene_of(square("0.025 m", "0.001 Pa s", periodic, R"toml([parameters]
U = "1 m/s"
L = "0.5 m"
[flow]
initial_velocity = ["x < L ? U : -U", "0 * U"]
sound_speed = "1 m/s"
reference_length = "1 m"
)toml"),
                  overrides);
}

// Momentum is kept pair by pair, but for what the transport velocity does.
double lost_momentum() {
  const auto scene = collision({{"effects.transport_velocity", "false"}});
  Fluid fluid(scene, sph::fill<2>(scene));
  fluid.advance(1.0);
  return fluid.momentum().norm() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
}

std::vector<Finding> impact() {
  const auto scene = collision();
  Fluid fluid(scene, sph::fill<2>(scene));
  const double start = fluid.kinetic_energy();
  const auto seen = watch(fluid, 3.0, 30);
  double least = 1.0;
  for (const std::uint32_t i : fluid.state().rows.fluid()) least = std::min(least, fluid.state().density[i]);
  return {at_most("fastest particle ever, in speeds of sound", seen.speed, 2.0),
          at_most("kinetic energy at the end, of that at the start", fluid.kinetic_energy() / start, 0.1),
          at_least("least density at the end, of that at rest", least, 0.5),
          at_most("mean velocity without transport velocity, in speeds of sound", lost_momentum(), 1e-12)};
}

}  // namespace

std::vector<Case> hard_walls() {
  return {{"stretched-patch", "pressures far below zero where fluid is torn apart", stretched_patch},
          // Does not hold: single particles reach 2.3 times the speed of sound.
          {.name = "impact", .what = "two halves of a fluid collide at Mach 1", .run = impact, .by_name_only = true}};
}

}  // namespace shmoo::run::verify
