#pragma once
// Fires fluid at walls: nothing may pass them, however fast it comes, however thin, curved, moving or cornered they
// are.
#include <Eigen/Geometry>
#include <numbers>

#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {

inline constexpr double shot_spacing = 0.025;  // [m] of particles

template <int D>
struct Range {
  using Vec = base::Vec<D>;

  std::string name, model;
  // How far [m] a place lies inside the wall, negative outside.
  std::function<double(const Vec& x, double t)> depth;
  // A number that jumps by more than a half where a particle passes through a wall that parts the fluid.
  std::function<double(const Vec& x, double t)> lap = [](const Vec&, double) { return 0.0; };
};

// Takes most of what earlier shots left of motion about the mean, so that the fluid does not heat without bound.
template <int D>
void calm(hydro::Fluid<D>& fluid, std::vector<base::Vec<D>>& velocity) {
  const base::Vec<D> mean = fluid.momentum() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
  for (const std::uint32_t i : fluid.state().rows.fluid()) velocity[i] = mean + 0.3 * (velocity[i] - mean);
}

// The way to the nearest solid particle about fluid particle i, of length `within` or more where none is nearer.
template <int D>
base::Vec<D> way_to_wall(const hydro::Fluid<D>& fluid, std::uint32_t i, double within) {
  const auto& state = fluid.state();
  base::Vec<D> nearest = base::Vec<D>::Constant(within);
  for (std::uint64_t p = state.rows.first(i); p < state.rows.first(i) + state.rows.count(i); ++p) {
    const auto j = std::size_t(state.rows.partner()[p]);
    if (fluid.particles().role[j] == sph::Role::fluid) continue;
    const base::Vec<D> x = state.separation(j, i);
    if (x.norm() < nearest.norm()) nearest = x;
  }
  return nearest;
}

// A direction across e, another one for every n.
template <int D>
base::Vec<D> across(const base::Vec<D>& e, std::size_t n) {
  if constexpr (D == 2) {
    return base::Vec<2>(-e[1], e[0]);
  } else {
    int least = 0;
    for (int a = 1; a < D; ++a)
      if (std::abs(e[a]) < std::abs(e[least])) least = a;
    const base::Vec<3> u = e.cross(base::Vec<3>::Unit(least)).normalized(), v = e.cross(u);
    return std::cos(double(n)) * u + std::sin(double(n)) * v;
  }
}

// Gives one in eight of the particles that touch a wall the speed of sound towards it, at angles up to 60 degrees.
template <int D>
std::size_t shoot(hydro::Fluid<D>& fluid, std::size_t& shots) {
  auto& velocity = fluid.particles().template require<base::Vec<D>>("velocity", "m/s").values();
  calm(fluid, velocity);
  constexpr double touches = 1.2 * shot_spacing;
  std::size_t fired = 0, turn = shots;
  for (const std::uint32_t i : fluid.state().rows.near_wall()) {
    const base::Vec<D> way = way_to_wall(fluid, i, touches);
    if (way.norm() >= touches || turn++ % 8 != 0) continue;
    const double part = double(shots++) * std::numbers::phi;  // evenly spread angles
    const double angle = std::numbers::pi / 3.0 * (2.0 * (part - std::floor(part)) - 1.0);
    const base::Vec<D> e = way.normalized();
    velocity[i] = fluid.scales().sound_speed * (std::cos(angle) * e + std::sin(angle) * across<D>(e, shots));
    ++fired;
  }
  ++shots;
  fluid.restart();
  return fired;
}

struct Fire {
  double shots = 0, inside = 0, through = 0, outside = 0;
  std::uint64_t bounces = 0;
};

template <int D>
Fire open_fire(const Range<D>& range, std::uint64_t hits) {
  const auto scene = scene_of(range.model);
  hydro::Fluid<D> fluid(scene, sph::fill<D>(scene));
  std::vector<double> lap(fluid.particles().size());
  const auto look = [&](const auto& visit) {
    for (const std::uint32_t i : fluid.state().rows.fluid()) {
      const auto& x = fluid.particles().position[i];
      visit(fluid.particles().id[i], range.lap(x, fluid.time()), range.depth(x, fluid.time()));
    }
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
        fire.inside += depth > 1e-6 * shot_spacing;
        lap[id] = now;
      });
    }
    fire.outside += count_outside(fluid);
  }
  fire.bounces = fluid.bounces();
  return fire;
}

// `hits` in all, shared out evenly.
template <int D>
std::vector<Finding> under_fire(const std::vector<Range<D>>& ranges, std::uint64_t hits) {
  std::vector<Finding> findings;
  const std::uint64_t each = hits / ranges.size();
  for (const Range<D>& range : ranges) {
    const Fire fire = open_fire(range, each);
    findings.push_back(exactly(range.name + ": particles gone through", fire.through, 0.0));
    findings.push_back(exactly(range.name + ": looks at a particle inside", fire.inside, 0.0));
    findings.push_back(exactly(range.name + ": looks at a particle outside", fire.outside, 0.0));
    findings.push_back(at_least(range.name + ": hits", double(fire.bounces), double(each)));
  }
  return findings;
}

std::vector<Range<3>> ranges_in_space();

}  // namespace shmoo::run::verify
