// Friction of fourth order: where it acts, and that it is.
#include <gtest/gtest.h>

#include <numbers>

#include "hydro/lattice_moments.hpp"
#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// A wave of shear, `across` particles long.
scene::Scene wave_scene(int across, double jitter) {
  auto scene = box_scene(2, 1.0, 1.0 / across, 1e-2);
  scene.domain.jitter = jitter;
  scene.flow.initial_velocity = {{0.0, "sin(2*_pi*y)"}, {0.0, ""}};
  scene.flow.reference_speed = 1.0;
  scene.effects.transport_velocity = false;
  return scene;
}

// The viscosity that the wave feels when it starts, over what it should be, less one.
double error(const scene::Scene& scene) {
  const auto fluid = make_fluid<2>(scene);
  const auto& state = fluid.state();
  EXPECT_NE(state.narrowing, nullptr);
  double lost = 0.0, energy = 0.0;
  for (const auto i : state.rows.fluid()) {
    lost -= state.acceleration[i].dot(state.velocity[i]);
    energy += state.velocity[i].squaredNorm();
  }
  const double k = 2.0 * std::numbers::pi;
  return lost / (energy * 1e-2 * k * k) - 1.0;
}

TEST(FourthOrder, HoldsWhereSecondOrderLosesTwoPercent) {
  for (const auto kernel : {scene::Kernel::wendland_c2, scene::Kernel::quintic_spline, scene::Kernel::lucy}) {
    for (const double jitter : {0.0, 0.2}) {
      auto scene = wave_scene(20, jitter);
      scene.numerics.kernel = kernel;
      EXPECT_LT(std::abs(error(scene)), jitter > 0.0 ? 1e-2 : 4e-3) << int(kernel) << ' ' << jitter;
    }
  }
}

// What diffuses density leaves a linear and a quadratic profile alone, and is of the right sign for short waves.
TEST(FourthOrder, DiffusesOnlyCurvatureOfPressure) {
  const auto scene = wave_scene(20, 0.0);
  const auto fluid = make_fluid<2>(scene);
  const double c = DensityDiffusion::derive(scene, fluid.scales()).narrowing;
  const auto moment = [&](int power) { return lattice_moment(scene, fluid.scales(), power); };
  EXPECT_NEAR(moment(2), c * moment(4), 1e-12 * moment(2));
  EXPECT_GT(moment(0), c * moment(2));
  EXPECT_EQ(DensityDiffusion::derive(poiseuille_scene(20), fluid.scales()).narrowing, 0.0);
}

TEST(FourthOrder, LeavesWallsNoiseAndShortKernelsAlone) {
  EXPECT_EQ(make_fluid<2>(poiseuille_scene(10)).state().narrowing, nullptr);
  auto scene = wave_scene(20, 0.0);
  scene.numerics.reach = 2.0;
  EXPECT_EQ(make_fluid<2>(scene).state().narrowing, nullptr);
  scene = wave_scene(20, 0.0);
  scene.effects.thermal_noise = true;
  scene.flow.thermal_energy = 1e-9;
  EXPECT_EQ(make_fluid<2>(scene).state().narrowing, nullptr);
  scene = wave_scene(20, 0.0);
  scene.materials[0].viscosity = 10.0;  // where it would shorten the step
  EXPECT_EQ(make_fluid<2>(scene).state().narrowing, nullptr);
}

}  // namespace
}  // namespace shmoo::hydro::testing
