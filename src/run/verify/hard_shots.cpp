// Walls under fire: nothing may pass them, however fast it comes, however thin, curved, moving or cornered they are.
#include <fmt/format.h>

#include <numbers>

#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

using Fluid = hydro::Fluid<2>;
using base::Vec;

constexpr double spacing = 0.025;  // [m]

struct Range {
  std::string name, sides, wall;
  // How far [m] a place lies inside the wall, negative outside.
  std::function<double(const Vec<2>& x, double t)> depth;
  // A number that jumps by more than a half where a particle passes through a plate that closes a ring.
  std::function<double(const Vec<2>& x, double t)> lap = [](const Vec<2>&, double) { return 0.0; };
};

std::string box_of_wall(double left, double width, double bottom, double height, const std::string& motion) {
  return fmt::format(
      "[materials.plate]\ntype = \"wall\"\n{}[[region]]\nmaterial = \"plate\"\nshape = \"box\"\n"
      "lower = [\"{} m\", \"{} m\"]\nupper = [\"{} m\", \"{} m\"]\n",
      motion, left, bottom, left + width, bottom + height);
}

// A plate across a channel that is closed to a ring.
Range plate(int layers, double speed) {
  const double width = layers * spacing;
  const auto lap = [=](const Vec<2>& x, double t) {
    const double from = x[0] - 0.5 - speed * t;
    return from - std::floor(from);
  };
  const std::string motion = speed == 0.0 ? "" : fmt::format("velocity = [\"{} m/s\", \"0 m/s\"]\n", speed);
  return {fmt::format("a plate of {} layer{}{}", layers, layers > 1 ? "s" : "", speed == 0.0 ? "" : " that moves"),
          R"({ x = "periodic", y = "wall" })", box_of_wall(0.5, width, 0.0, 1.0, motion),
          [=](const Vec<2>& x, double t) { return std::min(lap(x, t), width - lap(x, t)); }, lap};
}

Range ball(const char* name, double radius) {
  return {name, R"({ x = "wall", y = "wall" })",
          fmt::format("[materials.plate]\ntype = \"wall\"\n[[region]]\nmaterial = \"plate\"\nshape = \"disk\"\n"
                      "center = [\"0.5 m\", \"0.5 m\"]\nradius = \"{} m\"\n",
                      radius),
          [=](const Vec<2>& x, double) { return radius - (x - Vec<2>(0.5, 0.5)).norm(); }};
}

// One layer thick, turning once in two seconds: its ends run at 0.13 of the speed of sound.
Range paddle() {
  const double w = std::numbers::pi;
  return {"a paddle of one layer that turns", periodic,
          box_of_wall(0.1, 0.8, 0.4875, spacing,
                      fmt::format("angular_velocity = \"{} 1/s\"\ncenter = [\"0.5 m\", \"0.5 m\"]\n", w)),
          [=](const Vec<2>& x, double t) {
            const Vec<2> r = x - Vec<2>(0.5, 0.5), along(std::cos(w * t), std::sin(w * t));
            return std::min(0.4 - std::abs(r.dot(along)), 0.5 * spacing - std::abs(r.dot(Vec<2>(-along[1], along[0]))));
          }};
}

std::vector<Range> ranges() {
  return {plate(1, 0.0),
          plate(2, 0.0),
          plate(3, 0.0),
          plate(1, 2.0),
          plate(3, 2.0),
          ball("a ball in a box", 0.2),
          ball("a ball of four particles across", 0.05),
          paddle()};
}

// Takes most of what earlier shots left of motion about the mean, so that the fluid does not heat without bound.
void calm(Fluid& fluid, std::vector<Vec<2>>& velocity) {
  const Vec<2> mean = fluid.momentum() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
  for (const std::uint32_t i : fluid.state().rows.fluid()) velocity[i] = mean + 0.3 * (velocity[i] - mean);
}

// Gives one in eight of the particles that touch a wall the speed of sound towards it, at angles up to 60 degrees.
std::size_t shoot(Fluid& fluid, std::size_t& shots) {
  auto& velocity = fluid.particles().require<Vec<2>>("velocity", "m/s").values();
  calm(fluid, velocity);
  const auto& state = fluid.state();
  const double touches = 1.2 * spacing;
  std::size_t fired = 0, turn = shots;
  for (const std::uint32_t i : state.rows.near_wall()) {
    Vec<2> nearest = Vec<2>::Constant(touches);
    for (std::uint64_t p = state.rows.first(i); p < state.rows.first(i) + state.rows.count(i); ++p) {
      const auto j = std::size_t(state.rows.partner()[p]);
      if (fluid.particles().role[j] == sph::Role::fluid) continue;
      const Vec<2> x = state.separation(j, i);
      if (x.norm() < nearest.norm()) nearest = x;
    }
    if (nearest.norm() >= touches || turn++ % 8 != 0) continue;
    const double part = double(shots++) * std::numbers::phi;  // evenly spread angles
    const double angle = std::numbers::pi / 3.0 * (2.0 * (part - std::floor(part)) - 1.0);
    const Vec<2> e = nearest.normalized(), across(-e[1], e[0]);
    velocity[i] = fluid.scales().sound_speed * (std::cos(angle) * e + std::sin(angle) * across);
    ++fired;
  }
  ++shots;
  fluid.restart();
  return fired;
}

struct Fire {
  double shots = 0, inside = 0, through = 0, outside = 0;
};

Fire open_fire(const Range& range, std::uint64_t hits, std::uint64_t& bounces) {
  const auto scene = scene_of(square(fmt::format("{} m", spacing), "0.01 Pa s", range.sides,
                                     range.wall + "[flow]\nreference_speed = \"1 m/s\"\n[effects]\nflow = true\n"));
  Fluid fluid(scene, sph::fill<2>(scene));
  std::vector<double> lap(fluid.particles().size());
  const auto look = [&](const auto& visit) {
    for (const std::uint32_t i : fluid.state().rows.fluid())
      visit(fluid.particles().id[i], range.lap(fluid.particles().position[i], fluid.time()),
            range.depth(fluid.particles().position[i], fluid.time()));
  };
  look([&](std::size_t id, double now, double) { lap[id] = now; });
  Fire fire;
  std::size_t shots = 0;
  while (fluid.bounces() < hits && fluid.steps() < 50 * hits) {
    fire.shots += double(shoot(fluid, shots));
    for (int step = 0; step < 6; ++step) {
      fluid.step();
      look([&](std::size_t id, double now, double depth) {
        fire.through += std::abs(now - lap[id]) > 0.5;
        fire.inside += depth > 1e-6 * spacing;
        lap[id] = now;
      });
    }
    fire.outside += count_outside(fluid);
  }
  bounces = fluid.bounces();
  return fire;
}

std::vector<Finding> under_fire(std::uint64_t hits) {
  std::vector<Finding> findings;
  const auto all = ranges();
  for (const Range& range : all) {
    std::uint64_t bounces = 0;
    const Fire fire = open_fire(range, hits / all.size(), bounces);
    findings.push_back(exactly(range.name + ": particles gone through", fire.through, 0.0));
    findings.push_back(exactly(range.name + ": looks at a particle inside", fire.inside, 0.0));
    findings.push_back(exactly(range.name + ": looks at a particle outside", fire.outside, 0.0));
    findings.push_back(at_least(range.name + ": hits", double(bounces), double(hits / all.size())));
  }
  return findings;
}

}  // namespace

std::vector<Case> hard_shots() {
  return {{"shots-at-walls", "10^5 hits at Mach 1 on thin, curved, moving and cornered walls",
           [] { return under_fire(100'000); }},
          {"million-hits", "10^6 hits at Mach 1 on the same walls", [] { return under_fire(1'000'000); }, true}};
}

}  // namespace shmoo::run::verify
