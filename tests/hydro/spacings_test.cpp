// Two spacings in one flow.
#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "base/error.hpp"
#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// The box [lower, upper] at half the scene's spacing.
void refine(scene::Scene& scene, const scene::Point& lower, const scene::Point& upper) {
  auto shape = std::make_shared<const scene::Shape>(scene::Shape{scene::BoxShape{lower, upper}});
  scene.domain.refinements.push_back({shape, 0.5 * scene.domain.spacing, {}});
}

// The unit square, periodic, 40 coarse particles wide, the middle half of it fine.
scene::Scene square_scene() {
  auto scene = box_scene(2, 1.0, 1.0 / 40, 0.01);
  scene.flow.reference_speed = 1.0;
  refine(scene, {0.25, 0.0}, {0.75, 1.0});
  return scene;
}

scene::Scene stream_scene() {
  auto scene = square_scene();
  scene.flow.initial_velocity = {{1.0, ""}, {0.5, ""}};
  return scene;
}

// Of all the fluid, in coarse particles.
double mass(const Fluid<2>& fluid) {
  double sum = 0.0;
  for (const auto i : fluid.state().rows.fluid()) sum += (*fluid.state().share)[i];
  return sum;
}

struct Deviation {
  double mean = 0, largest = 0;  // root mean square by mass
};

template <class Expected>
Deviation deviation(const Fluid<2>& fluid, const Expected& expected) {
  Deviation deviation;
  for (const auto i : fluid.state().rows.fluid()) {
    const double off = (fluid.state().velocity[i] - expected(fluid.particles().position[i])).norm();
    deviation.largest = std::max(deviation.largest, off);
    deviation.mean += (*fluid.state().share)[i] * off * off;
  }
  deviation.mean = std::sqrt(deviation.mean / mass(fluid));
  return deviation;
}

const auto stream = [](const auto&) { return base::Vec<2>(1.0, 0.5); };
const auto parabola = [](const auto& x) { return base::Vec<2>(4.0 * x[1] * (1.0 - x[1]), 0.0); };

}  // namespace

TEST(Spacings, AFineZoneHoldsFourParticlesForOne) {
  const auto fluid = make_fluid<2>(square_scene());
  EXPECT_EQ(fluid.state().rows.fluid().size(), 800U + 3200U);
  EXPECT_EQ(mass(fluid), 1600.0);
  EXPECT_DOUBLE_EQ(fluid.scales().finest, 0.5 / 40);
  auto coarse = square_scene();
  coarse.domain.refinements.clear();
  EXPECT_DOUBLE_EQ(fluid.dt(), 0.5 * make_fluid<2>(coarse).dt());
}

TEST(Spacings, WhatRestsUnderPressureStaysAtRest) {
  auto scene = square_scene();
  scene.flow.background_pressure = 1.0;  // rho U^2
  auto fluid = make_fluid<2>(scene);
  fluid.advance(0.3);
  EXPECT_LT(fluid.max_speed(), 5e-4);
  EXPECT_LT(fluid.density_error(), 2e-4);
  EXPECT_EQ(fluid.spacings()->splits() + fluid.spacings()->merges(), 0U);
}

TEST(Spacings, AStreamPassesTheBorders) {
  auto fluid = make_fluid<2>(stream_scene());
  const base::Vec<2> start = fluid.momentum();
  fluid.advance(0.5);
  EXPECT_GT(fluid.spacings()->splits(), 500U);
  EXPECT_GT(fluid.spacings()->merges(), 1500U);
  EXPECT_EQ(mass(fluid), 1600.0);
  EXPECT_LT((fluid.momentum() - start).norm(), 1e-12 * start.norm());
  EXPECT_LT(deviation(fluid, stream).largest, 1e-10);
  EXPECT_LT(fluid.density_error(), 1e-10);
  EXPECT_GT(fluid.smallest_distance(), 0.4);
  EXPECT_NEAR(double(fluid.state().rows.fluid().size()), 4000.0, 200.0);
}

TEST(Spacings, AStreamUnderPressurePassesTheBorders) {
  auto scene = stream_scene();
  scene.flow.background_pressure = 1.0;  // rho U^2
  auto fluid = make_fluid<2>(scene);
  fluid.advance(0.5);
  const auto off = deviation(fluid, stream);
  EXPECT_EQ(mass(fluid), 1600.0);
  EXPECT_LT(off.mean, 0.005);
  EXPECT_LT(off.largest, 0.015);
  EXPECT_LT(fluid.density_error(), 1e-3);
}

// Without shifts, whose correction of the velocity does not keep momentum.
TEST(Spacings, PairForcesKeepMomentum) {
  auto scene = square_scene();
  scene.flow.initial_velocity = {{1.0, "1 + 0.3*sin(2*_pi*y)"}, {0.5, "0.5 + 0.3*sin(2*_pi*x)"}};
  scene.effects.transport_velocity = false;
  auto fluid = make_fluid<2>(scene);
  const base::Vec<2> start = fluid.momentum();
  fluid.advance(0.2);
  EXPECT_GT(fluid.spacings()->splits(), 100U);
  EXPECT_LT((fluid.momentum() - start).norm(), 1e-12 * start.norm());
}

TEST(Spacings, AChannelMayBeFineAlongOneWall) {
  auto scene = poiseuille_scene(20);
  scene.domain.upper[0] = 0.5;
  refine(scene, {0.0, 0.0}, {0.5, 0.5});
  auto fluid = make_fluid<2>(scene);
  fluid.advance(6.0);
  EXPECT_LT(deviation(fluid, parabola).largest, 0.005);
}

TEST(Spacings, AChannelFlowsThroughAFineZone) {
  auto scene = poiseuille_scene(20);
  scene.domain.upper[0] = 1.0;
  refine(scene, {0.25, 0.0}, {0.75, 1.0});
  auto fluid = make_fluid<2>(scene);
  fluid.advance(6.0);
  const auto off = deviation(fluid, parabola);
  EXPECT_LT(off.mean, 0.005);
  EXPECT_LT(off.largest, 0.012);
  EXPECT_LT(fluid.density_error(), 0.005);
}

TEST(Spacings, TaylorGreenVorticesDecayAcrossAFineZone) {
  auto scene = taylor_green_scene(50);
  refine(scene, {0.26, 0.26}, {0.74, 0.74});
  auto fluid = make_fluid<2>(scene);
  const double start = fluid.kinetic_energy();
  fluid.advance(0.5);
  const double decay = std::exp(-8.0 * std::numbers::pi * std::numbers::pi * 0.01 * 0.5);
  EXPECT_NEAR(fluid.max_speed() / decay, 1.0, 0.0075);
  EXPECT_NEAR(fluid.kinetic_energy() / (start * decay * decay), 1.0, 0.01);
}

TEST(Spacings, IdsAndPlacesAreNeverShared) {
  auto fluid = make_fluid<2>(stream_scene());
  for (int k = 1; k <= 3; ++k) {
    fluid.advance(0.1 * k);
    std::set<std::uint32_t> ids, places;
    for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
      EXPECT_TRUE(ids.insert(fluid.particles().id[i]).second);
      EXPECT_TRUE(places.insert(fluid.places()->of(i)).second);
      EXPECT_LT(fluid.places()->of(i), fluid.places()->all());
    }
  }
}

TEST(Spacings, TheBitsDoNotDependOnThreads) {
  const auto sums = [](int threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    auto fluid = make_fluid<2>(stream_scene());
    for (int k = 0; k < 60; ++k) fluid.step();
    omp_set_num_threads(before);
    EXPECT_GT(fluid.spacings()->merges(), 0U);
    std::vector<double> values;
    for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
      values.push_back(fluid.particles().id[i]);
      for (int a = 0; a < 2; ++a) values.push_back(fluid.particles().position[i][a]);
    }
    return values;
  };
  const auto one = sums(1);
  EXPECT_EQ(one, sums(2));
  EXPECT_EQ(one, sums(5));
}

TEST(Spacings, WhatTheyDoNotKnowIsRefused) {
  auto scene = square_scene();
  scene.effects.thermal_noise = true;
  scene.flow.thermal_energy = 1e-6;
  EXPECT_THROW(make_fluid<2>(scene), base::InputError);
}

}  // namespace shmoo::hydro::testing
