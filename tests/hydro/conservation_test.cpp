// Laws that hold to round-off: momentum, rest, uniform motion, Galilean invariance.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// Sum of |m v|: the scale of round-off in the momentum.
template <int D>
double momentum_scale(const Fluid<D>& fluid) {
  double sum = 0.0;
  for (const auto i : fluid.state().rows.fluid()) sum += fluid.velocity(i).norm();
  return fluid.scales().mass * fluid.scales().depth * sum;
}

template <int D>
std::vector<base::Vec<D>> velocities_by_id(const Fluid<D>& fluid) {
  std::vector<base::Vec<D>> v(fluid.particles().size());
  for (std::size_t i = 0; i < v.size(); ++i) v[fluid.particles().id[i]] = fluid.velocity(i);
  return v;
}

}  // namespace

TEST(Conservation, PairForcesKeepMomentumToRoundOff) {
  auto scene = taylor_green_scene(24);
  scene.domain.jitter = 0.2;
  scene.effects.transport_velocity = false;
  auto fluid = make_fluid<2>(scene);
  const auto before = fluid.momentum();
  for (int k = 0; k < 100; ++k) fluid.step();
  EXPECT_LT((fluid.momentum() - before).norm(), 1e-12 * momentum_scale(fluid));
}

template <int D>
void noise_keeps_momentum(int particles) {
  auto scene = box_scene(D, 1.0, 1.0 / particles, 0.1);
  scene.effects.thermal_noise = true;
  scene.effects.transport_velocity = false;
  scene.flow.thermal_energy = 1e-4;
  auto fluid = make_fluid<D>(scene);
  for (int k = 0; k < 100; ++k) fluid.step();
  EXPECT_GT(fluid.kinetic_energy(), 0.0);
  EXPECT_LT(fluid.momentum().norm(), 1e-12 * momentum_scale(fluid));
}

TEST(Conservation, NoiseKeepsMomentumToRoundOffIn2D) { noise_keeps_momentum<2>(12); }
TEST(Conservation, NoiseKeepsMomentumToRoundOffIn3D) { noise_keeps_momentum<3>(7); }

class UniformVelocity : public ::testing::TestWithParam<double> {};

// On disordered particles, with the transport velocity shifting them: dv/dt must be exactly zero.
TEST_P(UniformVelocity, IsUntouched) {
  auto scene = box_scene(2, 1.0, 1.0 / 16, 0.01);
  scene.domain.jitter = 0.3;
  scene.flow.initial_velocity = {{GetParam(), ""}, {-GetParam(), ""}};
  scene.flow.reference_speed = std::max(1.0, GetParam());
  auto fluid = make_fluid<2>(scene);
  for (int k = 0; k < 50; ++k) fluid.step();
  for (const auto i : fluid.state().rows.fluid()) {
    ASSERT_EQ(fluid.velocity(i)[0], GetParam());
    ASSERT_EQ(fluid.velocity(i)[1], -GetParam());
  }
  EXPECT_EQ(fluid.density_error(), 0.0);
}
INSTANTIATE_TEST_SUITE_P(Speeds, UniformVelocity, ::testing::Values(0.0, 1000.0));

TEST(Galilean, AMovingObserverSeesTheSameFlow) {
  auto scene = taylor_green_scene(24);
  scene.domain.jitter = 0.1;
  auto resting = make_fluid<2>(scene);
  for (auto& component : scene.flow.initial_velocity) component.expression += "+0.5";
  auto moving = make_fluid<2>(scene);
  for (int k = 0; k < 30; ++k) {
    resting.step();
    moving.step();
  }
  const auto a = velocities_by_id(resting), b = velocities_by_id(moving);
  for (std::size_t i = 0; i < a.size(); ++i) ASSERT_LT((b[i] - a[i] - base::Vec<2>(0.5, 0.5)).norm(), 1e-11);
}

TEST(OneParticle, MovesStraightAndCrossesAPeriodicSide) {
  auto scene = box_scene(3, 1.0, 0.1, 0.01);
  scene.domain.material = -1;
  const auto shape = std::make_shared<scene::Shape>(scene::Shape{scene::BoxShape{{0.8, 0.4, 0.4}, {0.9, 0.5, 0.5}}});
  scene.regions.push_back({shape, 0, {}});
  scene.flow.initial_velocity = {{1.0, ""}, {0.0, ""}, {0.0, ""}};
  auto fluid = make_fluid<3>(scene);
  ASSERT_EQ(fluid.particles().size(), 1u);
  fluid.advance(0.4);
  EXPECT_EQ(fluid.time(), 0.4);
  EXPECT_NEAR(fluid.particles().position[0][0], 0.25, 1e-12);
  EXPECT_EQ(fluid.velocity(0)[0], 1.0);
  EXPECT_EQ(fluid.temperature(), 0.0);
}

}  // namespace shmoo::hydro::testing
