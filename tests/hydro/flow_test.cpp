// Flows with a known answer, small enough to run at every build. The same at full size stand in long/.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

constexpr double pi = sph::pi;

// Least-squares slope of q over coordinate `axis` of the fluid particles.
template <class Value>
double slope(const Fluid<2>& fluid, int axis, Value value) {
  double n = 0, x = 0, q = 0, xx = 0, xq = 0;
  for (const auto i : fluid.state().rows.fluid()) {
    const double xi = fluid.particles().position[i][axis], qi = value(i);
    n += 1, x += xi, q += qi, xx += xi * xi, xq += xi * qi;
  }
  return (n * xq - x * q) / (n * xx - x * x);
}

}  // namespace

// Continuity's sign and the state equation: density falls where the flow expands, and a standing wave swings with c0 k.
TEST(Sound, ExpansionLowersDensityAndAWaveHasItsPeriod) {
  auto scene = box_scene(2, 1.0, 1.0 / 32, 0.0);
  scene.effects.viscosity = scene.effects.density_diffusion = scene.effects.transport_velocity = false;
  scene.flow.initial_velocity = {{0.0, "0.001*sin(2*_pi*x)"}, {}};
  scene.flow.sound_speed = 1.0;
  scene.flow.reference_speed = 0.01;
  auto fluid = make_fluid<2>(scene);
  fluid.step();
  for (const auto i : fluid.state().rows.fluid()) {
    const double expansion = std::cos(2 * pi * fluid.particles().position[i][0]);
    if (std::abs(expansion) < 0.1) continue;
    ASSERT_LT((fluid.state().density[i] - 1.0) * expansion, 0.0);
  }
  fluid.advance(1.0);  // one period of a wave of length 1 at c0 = 1
  double along = 0, across = 0;
  for (const auto i : fluid.state().rows.fluid()) {
    const double phase = 2 * pi * fluid.particles().position[i][0];
    along += fluid.velocity(i)[0] * std::sin(phase);
    across += (fluid.state().density[i] - 1.0) * std::cos(phase);
  }
  const double count = double(fluid.state().rows.fluid().size());
  EXPECT_NEAR(2 * along / count, 0.001, 0.00002);
  EXPECT_NEAR(2 * across / count, 0.0, 0.0001);
}

TEST(TaylorGreen, DecaysAtItsRateAndKeepsParticlesApart) {
  auto fluid = make_fluid<2>(taylor_green_scene(32));
  fluid.advance(1.0);
  const double exact = std::exp(-8 * pi * pi * 0.01 * fluid.time());
  EXPECT_NEAR(fluid.max_speed() / exact, 1.0, 0.02);
  EXPECT_NEAR(fluid.kinetic_energy() / (0.25 * exact * exact), 1.0, 0.03);
  EXPECT_GT(fluid.smallest_distance(), 0.7);
}

TEST(TaylorGreen, TheDifferenceFormIsAccurateToo) {
  auto scene = taylor_green_scene(32);
  scene.numerics.pressure = scene::PressureForm::difference;
  auto fluid = make_fluid<2>(scene);
  fluid.advance(0.5);
  EXPECT_NEAR(fluid.max_speed() / std::exp(-8 * pi * pi * 0.01 * 0.5), 1.0, 0.02);
}

TEST(Hydrostatics, PressureCarriesTheWeight) {
  auto scene = box_scene(2, 1.0, 1.0 / 20, 0.1);
  scene.domain.upper[0] = 0.5;
  add_walls(scene, 1);
  scene.flow.body_force = scene::Point{0.0, -1.0, 0.0};
  auto fluid = make_fluid<2>(scene);
  fluid.advance(7.0);
  EXPECT_NEAR(slope(fluid, 1, [&](auto i) { return fluid.state().pressure[i]; }), -1.0, 0.01);
  EXPECT_LT(fluid.max_speed(), 1e-4);
  EXPECT_EQ(fluid.bounces(), 0u);
}

TEST(Couette, ASlidingSideShearsTheFluid) {
  auto scene = box_scene(2, 1.0, 1.0 / 10, 1.0);
  add_walls(scene, 1);
  scene.domain.sides[1][1].velocity = {1.0, 0.0, 0.0};
  auto fluid = make_fluid<2>(scene);
  fluid.advance(1.0);
  for (const auto i : fluid.state().rows.fluid()) {
    ASSERT_NEAR(fluid.velocity(i)[0], fluid.particles().position[i][1], 2e-3);
    ASSERT_NEAR(fluid.velocity(i)[1], 0.0, 1e-4);
  }
}

TEST(Poiseuille, ABodyForceDrivesTheParabola) {
  auto fluid = make_fluid<2>(poiseuille_scene(12));
  fluid.advance(6.0);
  double error = 0.0;
  const auto& flowing = fluid.state().rows.fluid();
  for (const auto i : flowing) {
    const double y = fluid.particles().position[i][1];
    error += std::pow(fluid.velocity(i)[0] - 4 * y * (1 - y), 2);
  }
  EXPECT_LT(std::sqrt(error / double(flowing.size())), 0.02);
}

// Root mean square of u - 4 y (1 - y) after two viscous times.
double poiseuille_error(scene::WallForm walls) {
  auto scene = poiseuille_scene(12);
  scene.numerics.walls = walls;
  auto fluid = make_fluid<2>(scene);
  fluid.advance(10.0);
  const double start = std::exp(-pi * pi * 0.1 * 10.0) * 32.0 / (pi * pi * pi);  // what is left of the start
  double error = 0.0;
  const auto& flowing = fluid.state().rows.fluid();
  for (const auto i : flowing) {
    const double y = fluid.particles().position[i][1];
    error += std::pow(fluid.velocity(i)[0] - 4 * y * (1 - y) + start * std::sin(pi * y), 2);
  }
  return std::sqrt(error / double(flowing.size()));
}

TEST(Poiseuille, IsExactToRoundingOfTheArrangementWithWallsOfSecondOrder) {
  const double second = poiseuille_error(scene::WallForm::second_order);
  EXPECT_LT(second, 5e-4);
  EXPECT_LT(10 * second, poiseuille_error(scene::WallForm::extrapolated));
}

// Between cylinders of radii 0.3 and 0.9, the inner one turning: u = A r + B/r.
TEST(CircularCouette, AFittedWallKnowsItsCurvature) {
  auto scene = box_scene(2, 2.0, 1.0 / 16, 0.1);
  scene.domain.lower = {-1.1, -1.1, 0.0};
  scene.domain.upper = {1.1, 1.1, 0.0};
  scene.domain.material = 1;
  scene.materials.push_back({"outer", scene::MaterialType::wall, 0, 0, 0, {}, {}});
  scene.materials.push_back({"inner", scene::MaterialType::wall, 0, 0, 0, {}, scene::RigidMotion{{}, {0, 0, 2}, {}}});
  scene.regions.push_back({std::make_shared<scene::Shape>(scene::Shape{scene::BallShape{{}, 0.9}}), 0, {}});
  scene.regions.push_back({std::make_shared<scene::Shape>(scene::Shape{scene::BallShape{{}, 0.4}}), 2, {}});
  auto fluid = make_fluid<2>(scene);
  fluid.advance(4.0);
  const double a2 = 0.4 * 0.4, b2 = 0.9 * 0.9, A = -2 * a2 / (b2 - a2), B = 2 * a2 * b2 / (b2 - a2);
  double error = 0.0;
  const auto& flowing = fluid.state().rows.fluid();
  for (const auto i : flowing) {
    const auto& x = fluid.particles().position[i];
    const double rate = A + B / x.squaredNorm();
    error += (fluid.velocity(i) - base::Vec<2>(-rate * x[1], rate * x[0])).squaredNorm();
  }
  EXPECT_LT(std::sqrt(error / double(flowing.size())), 0.01);
  const double torque = 4 * pi * 0.1 * 2 * a2 * b2 / (b2 - a2);
  EXPECT_NEAR(fluid.wall_load(2, base::Vec<2>::Zero()).torque[2] / torque, -1.0, 0.05);
  EXPECT_NEAR(fluid.wall_load(1, base::Vec<2>::Zero()).torque[2] / torque, 1.0, 0.05);
}

// The same channel along z in three dimensions.
TEST(Poiseuille, HoldsIn3D) {
  auto scene = box_scene(3, 0.7, 0.1, 0.1);
  scene.domain.upper[1] = 1.0;
  add_walls(scene, 1);
  scene.flow.body_force = scene::Point{0.0, 0.0, 0.8};
  auto fluid = make_fluid<3>(scene);
  fluid.advance(3.0);
  for (const auto i : fluid.state().rows.fluid()) {
    const double y = fluid.particles().position[i][1];
    ASSERT_NEAR(fluid.velocity(i)[2], 4 * y * (1 - y) * (1 - std::exp(-pi * pi * 0.1 * 3.0)), 0.03);
  }
}

}  // namespace shmoo::hydro::testing
