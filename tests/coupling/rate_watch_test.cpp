// Intervals are cut where rates of methods that leap change in time, and only there.
#include "coupling/rate_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rdme/network.hpp"
#include "scene/read.hpp"

namespace {

using namespace shmoo;

coupling::RateWatch watch(const std::string& rate) {
  auto scene = scene::read_scene_text(R"toml(
title = "One rate"
dimension = 1
cross_section = "1 m^2"
[domain]
size = ["10 m"]
spacing = "1 m"
[materials.medium]
type = "still"
[parameters]
k = "1 1/s"
jump = "5 s"
w = "1 1/s"
X = "9 m"
[species.A]
diffusivity = "1 m^2/s"
initial = "100 molecules/m^3"
[[reaction]]
equation = "A -> nothing"
rate = ")toml" + rate + R"toml("
[run]
until = "10 s"
)toml",
                                            "rate.toml");
  scene.numerics.sampler = scene::Sampler::tau_leaping;
  return {scene, rdme::Network(scene), {{0.5, 0.0, 0.0}, {9.5, 0.0, 0.0}}, 10.0};
}

TEST(RateWatch, LeavesRatesAloneThatDoNotChange) {
  EXPECT_EQ(watch("k*A").latest(0.0, 10.0), 10.0);
  EXPECT_EQ(watch("k*A*(1 + 0*t)").latest(0.0, 10.0), 10.0);
}

TEST(RateWatch, ClosesInOnAJumpAndGoesOnBehindIt) {
  auto rates = watch("k*A*(1 + 99*(t > jump))");
  double t = 0.0, across = 0.0;
  int intervals = 0;
  while (t < 10.0) {
    const double end = rates.latest(t, 10.0);
    ASSERT_GT(end, t);
    if (t <= 5.0 && end > 5.0) across = end - t;
    t = end;
    ++intervals;
  }
  EXPECT_LT(across * 100.0 * 1000.0, 0.02);  // events expected while the mid-interval value may be wrong
  EXPECT_GT(across, 0.0);
  EXPECT_LT(intervals, 60);
}

// Over a quarter period of a sine the midpoint rule with these intervals is right to a thousandth.
TEST(RateWatch, ResolvesASmoothRate) {
  auto rates = watch("k*A*sin(w*t)^2");
  double t = 0.0, hazard = 0.0;
  while (t < 3.0) {
    const double end = rates.latest(t, 3.0), middle = 0.5 * (t + end);
    hazard += (end - t) * std::pow(std::sin(middle), 2);
    t = end;
  }
  const double exact = 1.5 - 0.25 * std::sin(6.0);
  EXPECT_NEAR(hazard / exact, 1.0, 2e-3);
}

// A rate that is no number at one of the places is the sampler's to refuse; the watch must end.
TEST(RateWatch, EndsWhereARateIsNoNumber) { EXPECT_EQ(watch("k*A*sqrt((X - x)/X + 0*w*t)").latest(0.0, 10.0), 10.0); }

}  // namespace
