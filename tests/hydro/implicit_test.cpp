// The implicit viscous step: the answer of the explicit one, in fewer steps; the temperature at any friction.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>
#include <numbers>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// A channel of unit width driven to the speed 0.01 at Re = 0.01.
scene::Scene slow_channel(int particles, scene::ViscousStep step) {
  auto scene = box_scene(2, 1.0, 1.0 / particles, 1.0);
  scene.domain.upper[0] = 10.0 / particles;
  add_walls(scene, 1);
  scene.flow.body_force = scene::Point{0.08, 0.0, 0.0};
  scene.numerics.viscous_step = step;
  return scene;
}

// RMS difference of velocities at the same time, relative to the largest.
double difference(const Fluid<2>& a, const Fluid<2>& b) {
  std::vector<base::Vec<2>> by_id(a.particles().size(), base::Vec<2>::Zero());
  for (const auto i : a.state().rows.fluid()) by_id[a.particles().id[i]] = a.velocity(i);
  double sum = 0.0;
  for (const auto i : b.state().rows.fluid()) sum += (b.velocity(i) - by_id[b.particles().id[i]]).squaredNorm();
  return std::sqrt(sum / double(b.state().rows.fluid().size())) / b.max_speed();
}

// A noisy box at rest whose pair friction stops a lone particle in `share` of a step, stepped implicitly.
scene::Scene noisy_box(int dimension, int particles, double friction) {
  auto scene = box_scene(dimension, 1.0, 1.0 / particles, 1.0);
  scene.effects.thermal_noise = true;
  scene.effects.transport_velocity = false;
  scene.flow.thermal_energy = 1e-4;
  scene.flow.sound_speed = 1.0;
  scene.numerics.viscous_step = scene::ViscousStep::implicit_step;
  const auto rate = [&](const auto& fluid) { return fluid.scales().friction * fluid.dt(); };
  const double now = dimension == 2 ? rate(make_fluid<2>(scene)) : rate(make_fluid<3>(scene));
  scene.materials[0].viscosity = friction / now;
  return scene;
}

template <int D>
double mean_temperature(const scene::Scene& scene, int steps) {
  auto fluid = make_fluid<D>(scene);
  for (int k = 0; k < 150; ++k) fluid.step();
  double sum = 0.0;
  for (int k = 0; k < steps; ++k) {
    fluid.step();
    sum += fluid.temperature();
  }
  EXPECT_LT(fluid.momentum().norm(), 1e-12 * fluid.scales().mass * double(fluid.particles().size()));
  return sum / steps / *scene.flow.thermal_energy;
}

}  // namespace

TEST(ImplicitFriction, AgreesWithTheExplicitStepInASlowChannel) {
  const double end[] = {0.03, 0.5};  // [s] starting up, and steady: the slowest mode takes 0.1
  auto small = make_fluid<2>(slow_channel(20, scene::ViscousStep::explicit_step));
  auto large = make_fluid<2>(slow_channel(20, scene::ViscousStep::implicit_step));
  EXPECT_GT(large.dt(), 8.0 * small.dt());
  for (const double t : end) {
    small.advance(t);
    large.advance(t);
    EXPECT_LT(difference(large, small), 0.005) << "at t = " << t;
  }
}

TEST(ImplicitFriction, IsChosenWhereItPays) {
  EXPECT_EQ(make_fluid<2>(slow_channel(20, scene::ViscousStep::automatic)).limits().size(), 2u) << "acoustic, force";
  const auto fast = make_fluid<2>(taylor_green_scene(20));
  EXPECT_EQ(fast.limits().back().name, "viscosity");
}

// The mean over the run has a standard error of 0.4 % (measured over parts of a longer one).
TEST(ImplicitFriction, HoldsTheTemperatureAtAnyFriction) {
  EXPECT_NEAR(mean_temperature<2>(noisy_box(2, 16, 0.4), 300), 1.0, 0.02);
  EXPECT_NEAR(mean_temperature<2>(noisy_box(2, 16, 4.0), 300), 1.0, 0.02);
  EXPECT_NEAR(mean_temperature<3>(noisy_box(3, 7, 4.0), 100), 1.0, 0.02);
}

TEST(ImplicitFriction, HasTheSameBitsForAnyThreads) {
  auto scene = slow_channel(60, scene::ViscousStep::implicit_step);
  scene.domain.upper[0] = 1.0;
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  auto one = make_fluid<2>(scene);
  for (int k = 0; k < 3; ++k) one.step();
  omp_set_num_threads(3);
  auto three = make_fluid<2>(scene);
  for (int k = 0; k < 3; ++k) three.step();
  omp_set_num_threads(before);
  for (const auto i : one.state().rows.fluid()) ASSERT_EQ(one.velocity(i), three.velocity(i));
}

// A flow that starts at rest, v = V (1 - exp(-t/tau)), changes in a step by dt/tau/(exp(t/tau) - 1) of itself, and as
// that falls so does what solutions must make up for.
TEST(ImplicitFriction, TheSolversWorkFallsWithTheChangeOfAStep) {
  auto fluid = make_fluid<2>(slow_channel(20, scene::ViscousStep::implicit_step));
  const auto decline_of_step = [&] {
    const auto& solver = *fluid.implicit_friction();
    const double before = solver.decline(), solutions = double(solver.solutions());
    fluid.step();
    return (solver.decline() - before) / (double(solver.solutions()) - solutions);
  };
  const auto until = [&](std::uint64_t step) {
    while (fluid.steps() + 1 < step) fluid.step();
    return decline_of_step();
  };
  const double tau = 1.0 / (std::numbers::pi * std::numbers::pi);  // [s] w^2/(pi^2 nu)
  const double at_4 = until(4), early = std::expm1(fluid.time() / tau);
  const double at_16 = until(16), late = std::expm1(fluid.time() / tau);
  EXPECT_NEAR(at_4 - at_16, std::log(late / early), 0.1);
}

}  // namespace shmoo::hydro::testing
