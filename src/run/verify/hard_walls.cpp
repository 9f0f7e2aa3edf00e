// Walls under fire: nothing may pass them, however fast it comes.
#include <numbers>

#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

using Fluid = hydro::Fluid<2>;
using base::Vec;

// Sides at rest, one that slides, a plate of a single layer and a disk that turns.
const std::string targets = R"toml([materials.plate]
type = "wall"
[materials.disk]
type = "wall"
angular_velocity = "3 rad/s"
center = ["0.3 m", "0.5 m"]
[[region]]
shape = "box"
lower = ["0.6 m", "0 m"]
upper = ["0.625 m", "1 m"]
material = "plate"
[[region]]
shape = "disk"
center = ["0.3 m", "0.5 m"]
radius = "0.15 m"
material = "disk"
[flow]
reference_speed = "1 m/s"
)toml";

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

// How many particles are deeper than half a spacing in a wall, or on the wrong side of the plate.
double count_through(const Fluid& fluid, const std::vector<bool>& left) {
  const double half = 0.5 * fluid.scales().spacing;
  double through = count_outside(fluid);
  for (const std::uint32_t i : fluid.state().rows.fluid()) {
    const Vec<2>& x = fluid.particles().position[i];
    const bool in_disk = (x - Vec<2>(0.3, 0.5)).norm() < 0.15 - half;
    through += in_disk || left[fluid.particles().id[i]] != (x[0] < 0.6 + half);
  }
  return through;
}

std::vector<Finding> shots_at_walls() {
  const std::string sides = R"({ x = "wall", y = "wall", y_max = { type = "wall", velocity = ["5 m/s", "0 m/s"] } })";
  const auto scene = scene_of(square("0.025 m", "0.01 Pa s", sides, targets));
  Fluid fluid(scene, sph::fill<2>(scene));
  std::vector<bool> left(fluid.particles().size());
  for (const std::uint32_t i : fluid.state().rows.fluid())
    left[fluid.particles().id[i]] = fluid.particles().position[i][0] < 0.6;
  constexpr std::size_t wanted = 1000000;
  double through = 0;
  std::size_t shots = 0, hits = 0;
  while (hits < wanted) {
    hits += shoot(fluid, shots);
    for (int step = 0; step < 5; ++step) fluid.step();
    through = std::max(through, count_through(fluid, left));
  }
  return {at_least("hits", double(hits), double(wanted)), exactly("particles through a wall", through, 0.0),
          at_least("bounces", double(fluid.bounces()), 1.0)};
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
      through += in > 0.0125 && in < 0.0625;
    }
  }
  return {at_least("hits", double(hits), 1e4), exactly("looks at a particle inside the slab", through, 0.0),
          at_least("bounces", double(fluid.bounces()), 1.0)};
}

// Two halves of the fluid run into each other, and into the walls behind, at the speed of sound.
std::vector<Finding> impact() {
  const std::string sides = R"({ x = "wall", y = "wall" })";
  const auto scene = scene_of(square("0.025 m", "0.001 Pa s", sides, R"toml([parameters]
U = "1 m/s"
[flow]
initial_velocity = ["x < 0.5 ? U : -U", "0 m/s"]
sound_speed = "1 m/s"
reference_speed = "1 m/s"
)toml"));
  Fluid fluid(scene, sph::fill<2>(scene));
  const double start = fluid.kinetic_energy();
  const auto seen = watch(fluid, 10.0, 200);
  return {exactly("particles outside", seen.outside, 0.0),
          at_most("fastest particle, in speeds of sound", seen.speed, 2.0),
          at_most("kinetic energy left, of that at the start", seen.final_energy, 0.1),
          at_least("smallest distance of particles, in spacings", seen.distance, 0.2),
          within("kinetic energy at the start", start, 0.49, 0.51)};
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
  return {{"shots-at-walls", "a million shots at Mach 1 at walls at rest, sliding, turning and thin", shots_at_walls},
          {"shots-at-a-moving-slab", "shots at Mach 1 at a wall that runs at Mach 0.2", shots_at_a_moving_slab},
          {"impact", "two halves of the fluid collide at Mach 1", impact},
          {"stretched-patch", "pressures far below zero where fluid is torn apart", stretched_patch}};
}

}  // namespace shmoo::run::verify
