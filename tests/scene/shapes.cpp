#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "scene/scene.hpp"

namespace shmoo::scene {
namespace {

ShapePointer shape(auto form) { return std::make_shared<const Shape>(Shape{form}); }

// Area of a shape inside the square [0, 1)^2, by random points; standard error below 0.002.
double area(const ShapePointer& what) {
  base::RandomSequence random({}, base::Stream::test);
  int inside = 0;
  constexpr int points = 100000;
  for (int i = 0; i < points; ++i) {
    const double x = random.uniform(), y = random.uniform();
    inside += contains(*what, {x, y, 0}, 2);
  }
  return static_cast<double>(inside) / points;
}

TEST(Shapes, HaveTheirAreas) {
  const auto disk = shape(BallShape{{0.5, 0.5, 0}, 0.4});
  const auto ring = shape(ShellShape{{0.5, 0.5, 0}, 0.2, 0.4});
  const auto box = shape(BoxShape{{0, 0, 0}, {0.5, 0.5, 0}});
  const auto star = shape(PolygonShape{{{0.1, 0.1}, {0.9, 0.1}, {0.9, 0.9}, {0.5, 0.3}, {0.1, 0.9}}});
  EXPECT_NEAR(area(disk), M_PI * 0.16, 0.01);
  EXPECT_NEAR(area(ring), M_PI * 0.12, 0.01);
  EXPECT_NEAR(area(box), 0.25, 0.01);
  EXPECT_NEAR(area(star), 0.64 - 0.5 * 0.8 * 0.6, 0.01);
  EXPECT_NEAR(area(shape(UnionShape{{disk, box}})), M_PI * 0.16 * 0.75 + 0.25, 0.01);
  EXPECT_NEAR(area(shape(DifferenceShape{disk, box})), M_PI * 0.16 * 0.75, 0.01);
  EXPECT_NEAR(area(shape(HalfSpaceShape{{0.5, 0.5, 0}, {1, 1, 0}})), 0.5, 0.01);
}

TEST(Shapes, NeighboursLeaveNoGapAndDoNotOverlap) {
  const auto core = shape(BallShape{{0, 0, 0}, 1.0});
  const auto shell = shape(ShellShape{{0, 0, 0}, 1.0, 2.0});
  const auto left = shape(HalfSpaceShape{{1, 0, 0}, {1, 0, 0}});
  const auto right = shape(HalfSpaceShape{{1, 0, 0}, {-1, 0, 0}});
  const auto first = shape(BoxShape{{-2, -2, 0}, {1, 2, 0}});
  const auto second = shape(BoxShape{{1, -2, 0}, {2, 2, 0}});
  for (int i = -7; i < 8; ++i)
    for (int j = -7; j < 8; ++j) {
      const Point point{0.25 * i, 0.25 * j, 0};
      const bool inside = point[0] * point[0] + point[1] * point[1] < 4;
      EXPECT_EQ(contains(*core, point, 2) + contains(*shell, point, 2), inside ? 1 : 0);
      EXPECT_EQ(contains(*left, point, 2) + contains(*right, point, 2), 1);
      EXPECT_EQ(contains(*first, point, 2) + contains(*second, point, 2), 1);
    }
}

TEST(Shapes, IgnoreAxesThatTheSceneLacks) {
  const auto ball = shape(BallShape{{0, 0, 5}, 1.0});
  EXPECT_TRUE(contains(*ball, {0.5, 9, 9}, 1));
  EXPECT_TRUE(contains(*ball, {0.5, 0.5, 9}, 2));
  EXPECT_FALSE(contains(*ball, {0.5, 0.5, 9}, 3));
}

TEST(Shapes, PolygonsAreHalfOpenToo) {
  const auto square = shape(PolygonShape{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}});
  const auto next = shape(PolygonShape{{{1, 0}, {2, 0}, {2, 1}, {1, 1}}});
  for (double x = 0; x < 2; x += 0.25)
    for (double y = 0; y < 1; y += 0.25) EXPECT_EQ(contains(*square, {x, y, 0}, 2) + contains(*next, {x, y, 0}, 2), 1);
}

// A cone and a cylinder on it by their volumes, from points of a cube; standard error below 0.002.
TEST(Shapes, RevolvedOutlinesHaveTheirVolumes) {
  const auto body = shape(PolygonShape{{{0, 0}, {0.5, 0.4}, {1, 0.4}, {1, 0}}});
  base::RandomSequence random({}, base::Stream::test);
  int inside = 0;
  constexpr int points = 200000;
  for (int i = 0; i < points; ++i) {
    const double x = random.uniform(), y = random.uniform() - 0.5, z = random.uniform() - 0.5;
    inside += contains(*body, {x, y, z}, 3);
  }
  EXPECT_NEAR(double(inside) / points, M_PI * 0.16 * (0.5 / 3.0 + 0.5), 0.005);
}

}  // namespace
}  // namespace shmoo::scene
