// Thermal noise holds the temperature, whatever the friction. False-alarm rate: the mean over the run has a standard
// error of about 0.5 % (measured over seeds); the bound of 2.5 % is five of them.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

constexpr double kT = 1e-4;  // [J]

scene::Scene noise_scene(int dimension, int particles) {
  auto scene = box_scene(dimension, 1.0, 1.0 / particles, 0.1);
  scene.effects.thermal_noise = true;
  scene.effects.transport_velocity = false;
  scene.flow.thermal_energy = kT;
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
  return sum / steps;
}

}  // namespace

TEST(ThermalNoise, HoldsTheTemperatureIn2D) {
  EXPECT_NEAR(mean_temperature<2>(noise_scene(2, 16), 1500) / kT, 1.0, 0.025);
}

TEST(ThermalNoise, HoldsTheTemperatureIn3D) {
  EXPECT_NEAR(mean_temperature<3>(noise_scene(3, 7), 300) / kT, 1.0, 0.025);
}

TEST(ThermalNoise, HoldsTheTemperatureWithBulkViscosity) {
  auto scene = noise_scene(2, 16);
  scene.materials[0].bulk_viscosity = 0.15;
  EXPECT_NEAR(mean_temperature<2>(scene, 1500) / kT, 1.0, 0.025);
}

// kT enters per depth: a scene of another depth with as much thermal energy a depth moves alike.
TEST(ThermalNoise, EntersPerDepth) {
  auto scene = noise_scene(2, 10);
  auto one = make_fluid<2>(scene);
  scene.depth = 0.5;
  scene.flow.thermal_energy = 0.5 * kT;
  auto half = make_fluid<2>(scene);
  for (int k = 0; k < 20; ++k) {
    one.step();
    half.step();
  }
  EXPECT_EQ(half.max_speed(), one.max_speed());
  EXPECT_DOUBLE_EQ(half.temperature(), 0.5 * one.temperature());
}

TEST(ThermalNoise, DiffersBetweenRealisationsOnly) {
  const auto scene = noise_scene(2, 10);
  auto a = make_fluid<2>(scene, {7, 3}), b = make_fluid<2>(scene, {7, 3}), c = make_fluid<2>(scene, {7, 4});
  for (int k = 0; k < 10; ++k) a.step(), b.step(), c.step();
  EXPECT_EQ(a.kinetic_energy(), b.kinetic_energy());
  EXPECT_NE(a.kinetic_energy(), c.kinetic_energy());
}

TEST(ThermalNoise, RefusesWhatCannotBalance) {
  auto scene = noise_scene(2, 10);
  scene.effects.viscosity = false;
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);
  scene.effects.viscosity = true;
  scene.materials[0].bulk_viscosity = 0.3;
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);
}

}  // namespace shmoo::hydro::testing
