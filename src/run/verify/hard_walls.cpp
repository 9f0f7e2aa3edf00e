// Walls under fire: nothing may pass them, however fast it comes.
#include <numbers>

#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

using Fluid = hydro::Fluid<2>;
using base::Vec;

// Gives every particle that touches a wall the speed of sound towards it, at angles up to 60 degrees; how many.
std::size_t shoot(Fluid& fluid, std::size_t& shots) {
  auto& velocity = fluid.particles().require<Vec<2>>("velocity", "m/s");
  const auto& state = fluid.state();
  const double touches = 1.2 * fluid.scales().spacing;
  std::size_t hits = 0;
  for (const std::uint32_t i : state.rows.near_wall()) {
    Vec<2> nearest = Vec<2>::Constant(touches);
    for (std::uint64_t p = state.rows.first(i); p < state.rows.first(i) + state.rows.count(i); ++p) {
      const auto j = std::size_t(state.rows.partner()[p]);
      if (fluid.particles().role[j] == sph::Role::fluid) continue;
      const Vec<2> x = state.separation(j, i);
      if (x.norm() < nearest.norm()) nearest = x;
    }
    if (nearest.norm() >= touches) continue;
    const double part = double(shots++) * std::numbers::phi;  // evenly spread angles
    const double angle = std::numbers::pi / 3.0 * (2.0 * (part - std::floor(part)) - 1.0);
    const Vec<2> e = nearest.normalized(), across(-e[1], e[0]);
    velocity[i] = fluid.scales().sound_speed * (std::cos(angle) * e + std::sin(angle) * across);
    ++hits;
  }
  fluid.restart();
  return hits;
}

// A slab of three layers runs at a fifth of the speed of sound through fluid that is shot against it.
std::vector<Finding> shots_at_a_moving_slab() {
  const auto scene = scene_of(square("0.025 m", "0.01 Pa s", periodic, R"toml([materials.slab]
type = "wall"
velocity = ["2 m/s", "0 m/s"]
[[region]]
shape = "box"
lower = ["0.5 m", "0 m"]
upper = ["0.575 m", "1 m"]
material = "slab"
[flow]
reference_speed = "1 m/s"
)toml"));
  Fluid fluid(scene, sph::fill<2>(scene));
  double through = 0;
  std::size_t shots = 0, hits = 0;
  while (fluid.time() < 1.0) {
    hits += shoot(fluid, shots);
    for (int step = 0; step < 5; ++step) fluid.step();
    for (const std::uint32_t i : fluid.state().rows.fluid()) {
      const double from = fluid.particles().position[i][0] - 0.5 - 2.0 * fluid.time();
      const double in = from - std::floor(from);
      through += in > 0.025 && in < 0.05;  // past the first layer
    }
  }
  return {at_least("hits", double(hits), 1e4), exactly("looks at a particle past the slab's first layer", through, 0.0),
          at_least("bounces", double(fluid.bounces()), 1.0)};
}

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

}  // namespace

std::vector<Case> hard_walls() {
  return {{"shots-at-a-moving-slab", "shots at Mach 1 at a wall that runs at Mach 0.2", shots_at_a_moving_slab},
          {"stretched-patch", "pressures far below zero where fluid is torn apart", stretched_patch}};
}

}  // namespace shmoo::run::verify
