// The formulations that a scene can choose among, each by laws of its own.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

using scene::DensityForm, scene::PressureForm;

bool has(const Fluid<2>& fluid, const std::string& effect) {
  const auto names = fluid.effects();
  return std::find(names.begin(), names.end(), effect) != names.end();
}

// Vortices on disordered particles, so that no symmetry helps.
scene::Scene disordered() {
  auto scene = taylor_green_scene(16);
  scene.domain.jitter = 0.2;
  return scene;
}

// Momentum that steps change; the transport velocity's part does not claim to conserve it.
double drift_of_momentum(scene::Scene scene, int steps) {
  scene.effects.transport_velocity = false;
  auto fluid = make_fluid<2>(scene);
  const base::Vec<2> start = fluid.momentum();
  for (int k = 0; k < steps; ++k) fluid.step();
  return (fluid.momentum() - start).norm() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
}

// Two halves of a gas that collide: kinetic energy goes into compression and heat.
scene::Scene collision(double spacing = 1.0 / 24, double viscosity = 0.0) {
  auto scene = box_scene(2, 1.0, spacing, viscosity);
  scene.flow.initial_velocity = {{0.0, "x < 0.5 ? 1 : -1"}, {0.0, "0"}};
  scene.flow.sound_speed = 1.0;
  return scene;
}

}  // namespace

class ConservingForms : public ::testing::TestWithParam<std::pair<PressureForm, DensityForm>> {};

TEST_P(ConservingForms, KeepMomentum) {
  auto scene = disordered();
  std::tie(scene.numerics.pressure, scene.numerics.density) = GetParam();
  EXPECT_LT(drift_of_momentum(scene, 50), 1e-13);
}
INSTANTIATE_TEST_SUITE_P(Forms, ConservingForms,
                         ::testing::Values(std::pair{PressureForm::symmetric, DensityForm::continuity},
                                           std::pair{PressureForm::symmetric, DensityForm::summation},
                                           std::pair{PressureForm::riemann, DensityForm::continuity},
                                           std::pair{PressureForm::riemann, DensityForm::summation}));

TEST(RiemannPressure, IsChosenBeyondAThirdOfTheSpeedOfSound) {
  auto scene = collision();
  EXPECT_TRUE(has(make_fluid<2>(scene), "Riemann pressure"));
  scene.flow.sound_speed = 10.0;
  EXPECT_TRUE(has(make_fluid<2>(scene), "symmetric pressure"));
  scene.numerics.pressure = PressureForm::riemann;
  EXPECT_TRUE(has(make_fluid<2>(scene), "Riemann pressure"));
}

TEST(RiemannPressure, LeavesAUniformMotionAlone) {
  auto scene = box_scene(2, 1.0, 1.0 / 16, 0.0);
  scene.numerics.pressure = PressureForm::riemann;
  scene.flow.initial_velocity = {{0.0, "0.3"}, {0.0, "-0.2"}};
  auto fluid = make_fluid<2>(scene);
  for (int k = 0; k < 30; ++k) fluid.step();
  for (const auto i : fluid.state().rows.fluid()) {
    EXPECT_NEAR(fluid.velocity(i)[0], 0.3, 1e-12);
    EXPECT_NEAR(fluid.velocity(i)[1], -0.2, 1e-12);
  }
}

// It may only take energy, and no particle outruns what the halves had by more than the rarefaction's edge scatters;
// with viscosity and without.
TEST(Shocks, Dissipate) {
  for (const double viscosity : {0.0, 1e-3}) {
    auto fluid = make_fluid<2>(collision(1.0 / 24, viscosity));
    const double start = fluid.kinetic_energy();
    double fastest = 0.0, largest = 0.0;
    for (int k = 1; k <= 30; ++k) {
      fluid.advance(0.1 * k);
      largest = std::max(largest, fluid.kinetic_energy());
      fastest = std::max(fastest, fluid.max_speed());
    }
    EXPECT_LT(largest, start);
    EXPECT_LT(fluid.kinetic_energy(), 0.1 * start);
    EXPECT_LT(fastest, 1.5);
  }
}

// Only where all is left to rules and the fluid fills its room: a gas spreads into what is empty, a fluid does not.
TEST(Shocks, AreThoseOfAGasWhereNothingElseIsSaid) {
  const auto is_gas = [](const scene::Scene& scene) {
    const auto fluid = make_fluid<2>(scene);
    EXPECT_EQ(has(fluid, "density by summation"), !has(fluid, "transport velocity"));
    EXPECT_EQ(fluid.scales().background > 0.0, fluid.scales().shocks);
    return fluid.scales().shocks;
  };
  EXPECT_TRUE(is_gas(collision()));
  auto slow = collision(), chosen = collision(), open = collision();
  slow.flow.sound_speed = 10.0;
  EXPECT_FALSE(is_gas(slow));
  chosen.numerics.density = DensityForm::continuity;
  EXPECT_FALSE(is_gas(chosen));
  open.domain.material = -1;
  open.regions.push_back(
      {std::make_shared<const scene::Shape>(scene::Shape{scene::BoxShape{{0.2, 0.2}, {0.8, 0.8}}}), 0, {}});
  EXPECT_FALSE(is_gas(open));
}

TEST(DensityBySummation, IsTheSumOverKernels) {
  auto scene = disordered();
  scene.numerics.density = DensityForm::summation;
  auto fluid = make_fluid<2>(scene);
  EXPECT_FALSE(has(fluid, "density diffusion"));
  for (int k = 0; k < 20; ++k) fluid.step();
  const auto kernel = sph::make_kernel<2>(scene.numerics.kernel, fluid.scales().reach);
  const auto& x = fluid.particles().position;
  for (std::size_t i = 0; i < fluid.particles().size(); i += 17) {
    double sum = 0.0;
    for (std::size_t j = 0; j < fluid.particles().size(); ++j)
      sum += std::visit([&](const auto& k) { return k.W(fluid.box().nearest(x[i] - x[j]).norm()); }, kernel);
    EXPECT_NEAR(fluid.state().density[i], sum / fluid.scales().lattice_sum, 1e-12);
  }
}

TEST(ShepardFilter, LeavesAUniformDensityAloneAndSmoothsAnother) {
  auto scene = box_scene(2, 1.0, 1.0 / 16, 0.0);
  scene.effects.density_diffusion = scene.effects.transport_velocity = false;
  scene.domain.jitter = 0.2;
  scene.flow.reference_speed = 1.0;
  scene.numerics.shepard_every = 1;
  auto fluid = make_fluid<2>(scene);
  fluid.step(1e-12);
  EXPECT_LT(fluid.density_error(), 1e-12);
  auto& density = fluid.particles().template require<double>("density", "kg/m^3");
  for (std::size_t i = 0; i < fluid.particles().size(); ++i) density[i] = i % 2 == 0 ? 1.01 : 0.99;
  fluid.restart();
  fluid.step(1e-12);
  EXPECT_LT(fluid.density_error(), 0.0099);  // of 0.01
  EXPECT_GT(fluid.density_error(), 1e-6);
}

TEST(ShepardFilter, ActsEverySoManySteps) {
  auto never = disordered(), late = disordered();
  late.numerics.shepard_every = 10;
  auto a = make_fluid<2>(never), b = make_fluid<2>(late);
  EXPECT_TRUE(has(b, "Shepard filter"));
  for (int k = 0; k < 9; ++k) a.step(), b.step();
  EXPECT_EQ(a.kinetic_energy(), b.kinetic_energy());
  for (int k = 0; k < 2; ++k) a.step(), b.step();
  EXPECT_NE(a.kinetic_energy(), b.kinetic_energy());
}

TEST(Formulations, RefuseWhatContradictsItself) {
  const auto refused = [](auto change) {
    auto scene = disordered();
    change(scene);
    EXPECT_THROW(make_fluid<2>(scene), base::InputError);
  };
  refused([](auto& scene) {
    scene.numerics.shepard_every = 10;
    scene.numerics.density = DensityForm::summation;
  });
  const auto noisy = [](auto& scene) {
    scene.effects.transport_velocity = false;
    scene.effects.thermal_noise = true;
    scene.flow.thermal_energy = 1e-6;
  };
  refused([&](auto& scene) {
    noisy(scene);
    scene.numerics.density = DensityForm::continuity;
  });
  refused([&](auto& scene) {
    noisy(scene);
    scene.numerics.pressure = PressureForm::riemann;
  });
}

}  // namespace shmoo::hydro::testing
