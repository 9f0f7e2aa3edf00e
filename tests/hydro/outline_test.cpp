// What is measured on a shell's outline, and what fills its cavity.
#include "hydro/shell/outline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hydro/shell/filling.hpp"

namespace shmoo::hydro::testing {
namespace {

using std::numbers::pi;

// An ellipse with half axes a (along x) and b.
Points ellipse(double a, double b, int points) {
  Points outline;
  for (int k = 0; k < points; ++k) {
    const double angle = pi * (k + 0.5) / points;
    outline.emplace_back(a * std::cos(angle), b * std::sin(angle));
  }
  return outline;
}

TEST(Outline, OfAnEllipse) {
  const auto outline = ellipse(3.0, 1.0, 400);
  EXPECT_NEAR(length_along_axis(outline), 6.0, 1e-5);
  EXPECT_NEAR(tip_curvature(outline, 0.1), 3.0, 0.1);
  EXPECT_NEAR(least_curvature(outline, 0.1), 1.0 / 9.0, 0.002);  // b/a^2 at the side
  EXPECT_NEAR(arc_length(outline).back(), 0.5 * 13.3649, 0.02);  // 12 E(sqrt(8)/3)
}

TEST(Outline, ANeckIsConcave) {
  Points outline;
  for (int k = 0; k < 400; ++k) {
    const double t = pi * (k + 0.5) / 400;
    outline.emplace_back(2.0 * std::cos(t), std::sin(t) * (0.6 + 0.6 * std::cos(t) * std::cos(t)));
  }
  EXPECT_LT(least_curvature(outline, 0.1), -0.1);
}

TEST(Filling, FollowsAFingerAndNeverLeavesIt) {
  Points particles;
  for (double x = -0.95; x < 1.0; x += 0.1) {
    for (double y = 0.05; y < 1.0; y += 0.1)
      if (std::hypot(x, y) < 0.95) particles.emplace_back(x, y);
  }
  for (int step = 0; step <= 300; ++step) {
    auto outline = ellipse(1.0, 1.0, 80);  // of which the tip is drawn out into a finger
    for (auto& point : outline)
      if (point[0] > 0.8) point[0] += 0.02 / 3.0 * step * (point[0] - 0.8) / 0.2;
    relax(particles, outline);
    for (const auto& x : particles) ASSERT_TRUE(inside(outline, x)) << step;
  }
  double farthest = 0.0, closest = 1.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    farthest = std::max(farthest, particles[i][0]);
    for (std::size_t j = 0; j < i; ++j) closest = std::min(closest, (particles[i] - particles[j]).norm());
  }
  EXPECT_GT(farthest, 2.3);
  EXPECT_GT(closest, 0.05);
}

}  // namespace
}  // namespace shmoo::hydro::testing
