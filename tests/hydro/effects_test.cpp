// "Costs nothing when absent" has six meters: arithmetic, columns, reach, step limit, draws, output. And an effect that
// is present with nothing to do gives the same bits as one that is absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <set>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// A jittered box with walls and the least that a flow can have.
scene::Scene bare_scene() {
  auto scene = box_scene(2, 1.0, 1.0 / 16, 0.0);
  add_walls(scene, 1);
  scene.domain.jitter = 0.1;
  scene.flow.initial_velocity = {{0.0, "sin(6*y)"}, {0.0, "cos(6*x)"}};
  scene.flow.reference_speed = 1.0;
  scene.effects.viscosity = scene.effects.density_diffusion = scene.effects.transport_velocity = false;
  scene.effects.bounce_back = false;
  scene.numerics.walls = scene::WallForm::extrapolated;
  return scene;
}

std::set<std::string> columns(const Fluid<2>& fluid) {
  std::set<std::string> names;
  for (const auto& column : fluid.particles().columns()) names.insert(column->name());
  return names;
}

std::set<std::string> limits(const Fluid<2>& fluid) {
  std::set<std::string> names;
  for (const auto& limit : fluid.limits()) names.insert(limit.name);
  return names;
}

std::vector<double> state_after(const scene::Scene& scene, int steps) {
  auto fluid = make_fluid<2>(scene);
  for (int k = 0; k < steps; ++k) fluid.step();
  std::vector<double> values(5 * fluid.particles().size());
  for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
    double* at = values.data() + 5 * fluid.particles().id[i];
    for (int a = 0; a < 2; ++a) {
      *at++ = fluid.particles().position[i][a];
      *at++ = fluid.state().velocity[i][a];
    }
    *at = fluid.state().density[i];
  }
  return values;
}

void expect_same_bits(const scene::Scene& absent, const scene::Scene& zero) {
  const auto a = state_after(absent, 40), b = state_after(zero, 40);
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(double)), 0);
}

}  // namespace

TEST(AbsentEffects, LeaveTheBareFlow) {
  const auto fluid = make_fluid<2>(bare_scene());
  EXPECT_EQ(fluid.effects(), (std::vector<std::string>{"symmetric pressure", "density by continuity"}));
  const std::set<std::string> bare{"position",     "id",      "material", "role",   "velocity",
                                   "acceleration", "density", "pressure", "volume", "wall_velocity"};
  EXPECT_EQ(columns(fluid), bare);
  EXPECT_EQ(limits(fluid), std::set<std::string>{"acoustic"});
  EXPECT_EQ(fluid.draws(), 0u);
}

TEST(AbsentEffects, ABoxWithoutWallsHasNoWallColumn) {
  const auto fluid = make_fluid<2>(taylor_green_scene(12));
  EXPECT_FALSE(columns(fluid).contains("wall_velocity"));
}

// Every effect: its columns, its limit, its draws, and no others'.
TEST(PresentEffects, BringTheirColumnsLimitsAndDrawsOnly) {
  const auto base = make_fluid<2>(bare_scene());
  const auto added = [&](const Fluid<2>& fluid) {
    std::set<std::string> more;
    std::ranges::set_difference(columns(fluid), columns(base), std::inserter(more, more.end()));
    return more;
  };
  auto scene = bare_scene();
  scene.materials[0].viscosity = 0.01;
  scene.effects.viscosity = true;
  const auto viscous = make_fluid<2>(scene);
  EXPECT_EQ(added(viscous), std::set<std::string>{"scaling"});
  EXPECT_EQ(limits(viscous), (std::set<std::string>{"acoustic", "viscosity"}));

  scene.effects.thermal_noise = true;
  scene.flow.thermal_energy = 1e-6;
  auto noisy = make_fluid<2>(scene);
  EXPECT_EQ(added(noisy), (std::set<std::string>{"scaling", "noise"}));
  EXPECT_EQ(limits(noisy), (std::set<std::string>{"acoustic", "viscosity", "thermal noise"}));
  EXPECT_GT(noisy.draws(), 0u);

  scene = bare_scene();
  scene.effects.transport_velocity = true;
  EXPECT_EQ(added(make_fluid<2>(scene)), std::set<std::string>{"shift_velocity"});
  scene = bare_scene();
  scene.effects.density_diffusion = true;
  EXPECT_TRUE(added(make_fluid<2>(scene)).empty());
  scene = bare_scene();
  scene.numerics.pressure = scene::PressureForm::difference;
  EXPECT_EQ(added(make_fluid<2>(scene)), std::set<std::string>{"correction"});
  scene = bare_scene();
  scene.flow.body_force = scene::Point{0.1, 0.0, 0.0};
  const auto forced = make_fluid<2>(scene);
  EXPECT_TRUE(added(forced).empty());
  EXPECT_EQ(limits(forced), (std::set<std::string>{"acoustic", "body force"}));
}

TEST(PresentEffects, NeverWidenTheReach) {
  auto all = cavity_scene(16, 100);
  all.effects.thermal_noise = true;
  all.flow.thermal_energy = 1e-6;
  EXPECT_EQ(make_fluid<2>(all).state().rows.cutoff(), make_fluid<2>(bare_scene()).state().rows.cutoff());
}

// Intervals are observed only where somebody asks.
TEST(Intervals, HaveColumnsFromTheFirstOneOn) {
  auto fluid = make_fluid<2>(taylor_green_scene(12));
  EXPECT_FALSE(columns(fluid).contains("mean_shift"));
  fluid.begin_interval();
  EXPECT_TRUE(columns(fluid).contains("mean_shift"));
  fluid.advance(0.05);
  double shift = 0.0, error = 0.0;
  for (const auto i : fluid.state().rows.fluid()) {
    shift = std::max(shift, fluid.mean_shift(i).norm());
    error = std::max(error, (fluid.mean_velocity(i) - fluid.velocity(i)).norm());
  }
  EXPECT_GT(shift, 0.0);
  EXPECT_LT(error, 0.3);
}

TEST(SameBits, ViscosityAtZero) {
  auto zero = bare_scene();
  zero.effects.viscosity = true;
  expect_same_bits(bare_scene(), zero);
}

TEST(SameBits, BodyForceAtZero) {
  auto zero = bare_scene();
  zero.flow.body_force = scene::Point{0.0, 0.0, 0.0};
  expect_same_bits(bare_scene(), zero);
}

TEST(SameBits, BounceBackWithNothingToThrow) {
  auto idle = bare_scene();
  idle.effects.bounce_back = true;
  expect_same_bits(bare_scene(), idle);
}

// The slots whose strength comes from the flow itself are put in by hand with a strength of zero.
TEST(SameBits, SlotsAtZero) {
  const auto scene = bare_scene();
  auto absent = make_fluid<2>(scene);
  Effects<2> effects;
  effects.density_diffusion = DensityDiffusion{0.0};
  effects.transport_velocity = TransportVelocity<2>{0.0, 0.1};
  effects.viscosity = Viscosity<2>{0.0, 0.0};
  effects.thermal_noise = ThermalNoise<2>{0.0, 0.0, {1, 0}};
  Fluid<2> zero(scene, sph::fill<2>(scene), std::move(effects));
  for (int k = 0; k < 20; ++k) {
    absent.step(1e-3);
    zero.step(1e-3);
  }
  for (std::size_t i = 0; i < absent.particles().size(); ++i) {
    ASSERT_EQ(absent.particles().id[i], zero.particles().id[i]);
    ASSERT_EQ(absent.state().velocity[i], zero.state().velocity[i]);
    ASSERT_EQ(absent.particles().position[i], zero.particles().position[i]);
    ASSERT_EQ(absent.state().density[i], zero.state().density[i]);
  }
  EXPECT_GT(zero.draws(), 0u);
}

// A sponge pulls the velocity to its target at its rate, whatever the step.
TEST(Sponge, RelaxesAtItsRate) {
  auto scene = box_scene(2, 1.0, 0.1, 0.0);
  scene.effects.viscosity = false;
  scene::Inflow inflow;
  inflow.zone = std::make_shared<scene::Shape>(scene::Shape{scene::BoxShape{{-1, -1, 0}, {2, 2, 0}}});
  inflow.velocity = scene::Point{1.0, 0.0, 0.0};
  inflow.relaxation_time = 0.5;
  scene.inflows.push_back(inflow);
  auto fluid = make_fluid<2>(scene);
  fluid.advance(1.0);
  for (const auto i : fluid.state().rows.fluid()) ASSERT_NEAR(fluid.velocity(i)[0], 1.0 - std::exp(-2.0), 2e-3);
}

// Without a relaxation time it is short enough to hold the flow against the friction of the walls. At ten particles
// across, the turn from a plug into a parabola costs 8 % (20 across: 6 %).
TEST(Sponge, HoldsAChannelAtItsSpeed) {
  auto scene = box_scene(2, 1.0, 0.1, 0.1);
  scene.domain.upper[0] = 2.0;
  add_walls(scene, 1);
  scene::Inflow inflow;
  inflow.zone = std::make_shared<scene::Shape>(scene::Shape{scene::BoxShape{{0, 0, 0}, {0.5, 1, 0}}});
  inflow.velocity = scene::Point{1.0, 0.0, 0.0};
  scene.inflows.push_back(inflow);
  auto fluid = make_fluid<2>(scene);
  fluid.advance(4.0);
  EXPECT_NEAR(fluid.momentum()[0] / scene.domain.upper[0], 1.0, 0.1);
}

TEST(Refusals, AreClear) {
  auto scene = bare_scene();
  scene.flow = {};
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);  // nothing moves
  scene = bare_scene();
  scene.materials.push_back({"oil", scene::MaterialType::fluid, 0.9, 0.1, 0.0, {}, {}});
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);  // two fluids
  scene = bare_scene();
  scene.domain.upper[0] = 0.3;
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);  // narrower than two reaches
  scene = bare_scene();
  scene.flow.initial_velocity = {{0.0, "sin(q)"}, {}};
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);  // unknown name
}

TEST(Removing, AnEffectLeavesNothingOfIt) {
  auto scene = bare_scene();
  scene.effects.viscosity = scene.effects.density_diffusion = scene.effects.transport_velocity = true;
  scene.effects.bounce_back = true;
  scene.flow.body_force = scene::Point{1.0, 0.0, 0.0};
  auto filling = sph::fill<2>(scene);
  std::vector<Derived> derived;
  const auto scales = derive_scales<2>(scene, filling, derived);
  for (const std::string name :
       {"viscosity", "density diffusion", "transport velocity", "closed room", "bounce back", "body force"}) {
    auto effects = Effects<2>::choose(scene, scales, {});
    EXPECT_TRUE(effects.remove(name));
    EXPECT_FALSE(effects.remove(name)) << "it is gone";
    const auto left = effects.names();
    EXPECT_EQ(std::count(left.begin(), left.end(), name), 0);
  }
  auto effects = Effects<2>::choose(scene, scales, {});
  EXPECT_FALSE(effects.remove("symmetric pressure")) << "some form of pressure always acts";
  EXPECT_TRUE(effects.remove("transport velocity"));
  const Fluid<2> without(scene, std::move(filling), std::move(effects));
  EXPECT_FALSE(columns(without).contains("shift_velocity"));
}

}  // namespace shmoo::hydro::testing
