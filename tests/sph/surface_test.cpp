// The surface of walls: exact feet, normals and distances on planes and spheres, hidden pieces and corners left out.
#include "sph/surface.hpp"

#include <gtest/gtest.h>

namespace {

using namespace shmoo;
using base::Vec;

scene::ShapePointer shape(auto form) { return std::make_shared<scene::Shape>(scene::Shape{form}); }

// Fluid in a box of 10 spacings, walls beyond y, periodic along x.
scene::Scene box(int dimension = 2) {
  scene::Scene scene;
  scene.dimension = dimension;
  scene.domain.spacing = 1.0;
  scene.domain.material = 0;
  for (int a = 0; a < dimension; ++a) scene.domain.upper[std::size_t(a)] = 10.0;
  scene.domain.sides[0][0].type = scene.domain.sides[0][1].type = scene::SideType::periodic;
  scene.materials.push_back({"fluid", scene::MaterialType::fluid, 1.0, 1.0, 0.0, {}, {}});
  scene.materials.push_back({"wall", scene::MaterialType::wall, 0, 0, 0, {}, {}});
  return scene;
}

TEST(Surface, ASideIsAPlane) {
  const auto scene = box();
  const sph::Surface<2> surface(scene);
  const auto point = surface.nearest({3.0, -1.5}, 3.0);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->place, Vec<2>(3.0, 0.0));
  EXPECT_EQ(point->normal, Vec<2>(0.0, 1.0));
  EXPECT_DOUBLE_EQ(point->distance(Vec<2>(2.0, 0.7)), 0.7);
  EXPECT_FALSE(surface.nearest({3.0, -3.5}, 3.0));
}

TEST(Surface, ABallIsConvexAndARingHollow) {
  auto scene = box();
  scene.regions.push_back({shape(scene::BallShape{{5, 5, 0}, 2.0}), 1, {}});
  const sph::Surface<2> convex(scene);
  auto point = convex.nearest({5.0, 6.2}, 3.0);
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->place - Vec<2>(5, 7)).norm(), 0.0, 1e-14);
  EXPECT_NEAR((point->normal - Vec<2>(0, 1)).norm(), 0.0, 1e-14);
  const Vec<2> x(6.5, 7.5);
  EXPECT_NEAR(point->distance(x - point->place), (x - Vec<2>(5, 5)).norm() - 2.0, 1e-14);
  EXPECT_NEAR((point->normal_at(x - point->place) - (x - Vec<2>(5, 5)).normalized()).norm(), 0.0, 1e-14);

  scene.regions.clear();
  scene.domain.material = 1;
  scene.regions.push_back({shape(scene::BallShape{{5, 5, 0}, 4.0}), 0, {}});
  const sph::Surface<2> hollow(scene);
  point = hollow.nearest({5.0, 9.5}, 3.0);
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->normal - Vec<2>(0, -1)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(point->distance(x - point->place), 4.0 - (x - Vec<2>(5, 5)).norm(), 1e-14);
}

TEST(Surface, HiddenPiecesAndCornersHaveNoFoot) {
  auto scene = box();
  scene.domain.sides[0][0].type = scene.domain.sides[0][1].type = scene::SideType::wall;
  const sph::Surface<2> corner(scene);
  EXPECT_FALSE(corner.nearest({-0.5, -0.5}, 3.0));
  const auto beside = corner.nearest({2.0, -0.5}, 3.0), middle = corner.nearest({5.0, -0.5}, 3.0);
  ASSERT_TRUE(beside && middle);
  EXPECT_FALSE(corner.smooth_about(*beside, 3.0));
  EXPECT_TRUE(corner.smooth_about(*middle, 3.0));

  // Two boxes that overlap are one: the face of the first inside the second is none.
  scene.regions.push_back({shape(scene::BoxShape{{2, 3, 0}, {5, 7, 0}}), 1, {}});
  scene.regions.push_back({shape(scene::BoxShape{{4, 3, 0}, {9, 7, 0}}), 1, {}});
  const sph::Surface<2> joined(scene);
  const auto point = joined.nearest({4.9, 5.5}, 3.0);
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->place - Vec<2>(4.9, 7.0)).norm(), 0.0, 1e-14);
}

TEST(Surface, GoesOnThroughPeriodicSides) {
  auto scene = box();
  scene.regions.push_back({shape(scene::HalfSpaceShape{{0, 4, 0}, {0, 1, 0}}), 1, {}});
  scene.regions.push_back({shape(scene::BallShape{{0, 4, 0}, 2.0}), 1, {}});
  scene.regions.push_back({shape(scene::BallShape{{10, 4, 0}, 2.0}), 1, {}});
  const sph::Surface<2> surface(scene);
  const auto point = surface.nearest({9.5, 5.0}, 3.0);
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->place - Vec<2>(10, 4)).norm(), 2.0, 1e-14);
}

// Cutting fluid out of a wall, in 3-D, and an inclined polygon.
TEST(Surface, DifferencesAndPolygonsShowTheirFaces) {
  auto scene = box(3);
  scene.domain.material = 1;
  const auto ball = shape(scene::BallShape{{5, 5, 5}, 4.0}), core = shape(scene::BallShape{{5, 5, 5}, 1.0});
  scene.regions.push_back({shape(scene::DifferenceShape{ball, core}), 0, {}});
  const sph::Surface<3> surface(scene);
  auto inner = surface.nearest({5.0, 5.0, 5.5}, 2.0), outer = surface.nearest({5.0, 9.5, 5.0}, 2.0);
  ASSERT_TRUE(inner && outer);
  EXPECT_NEAR(inner->curvature, 1.0, 1e-14);
  EXPECT_NEAR(outer->curvature, -0.25, 1e-14);

  auto flat = box();
  flat.regions.push_back({shape(scene::PolygonShape{{{{0, 0}, {10, 0}, {10, 5}, {0, 2}}}}), 1, {}});
  const sph::Surface<2> polygon(flat);
  const Vec<2> along = Vec<2>(10, 3).normalized(), n(-along[1], along[0]);
  const auto point = polygon.nearest(Vec<2>(0, 2) + 5.0 * along - 0.7 * n, 3.0);
  ASSERT_TRUE(point);
  EXPECT_NEAR((point->normal - n).norm(), 0.0, 1e-14);
  EXPECT_NEAR((point->place - Vec<2>(0, 2) - 5.0 * along).norm(), 0.0, 1e-14);
}

// A pipe that widens to a cone: its surface is met at right angles, whichever way round the axis one looks.
TEST(Surface, RevolvedOutlinesShowTheirCones) {
  auto scene = box(3);
  scene.domain.lower = {0, -5, -5};
  scene.domain.upper = {10, 5, 5};
  scene.domain.material = 1;
  scene.regions.push_back({shape(scene::PolygonShape{{{{0, 0}, {0, 1}, {5, 1}, {10, 4}, {10, 0}}}}), 0, {}});
  const sph::Surface<3> surface(scene);
  const Vec<2> along = Vec<2>(5, 3).normalized(), n(along[1], -along[0]);  // of the cone, into the fluid
  for (const double angle : {0.0, 1.0, 2.5, 4.0}) {
    const auto turned = [&](const Vec<2>& p) { return Vec<3>(p[0], p[1] * std::cos(angle), p[1] * std::sin(angle)); };
    const auto pipe = surface.nearest(turned({2.0, 1.6}), 2.0);
    ASSERT_TRUE(pipe);
    EXPECT_NEAR((pipe->place - turned({2.0, 1.0})).norm(), 0.0, 1e-13);
    EXPECT_NEAR((pipe->normal - turned({0.0, -1.0})).norm(), 0.0, 1e-13);
    EXPECT_NEAR(pipe->curvature, -1.0, 1e-13);
    EXPECT_NEAR(pipe->distance(Vec<3>(3.5, 0.7, 0.0) - pipe->place), 0.3, 1e-13);  // all along and round the pipe
    const Vec<2> foot = Vec<2>(5, 1) + 3.0 * along;
    const auto cone = surface.nearest(turned(foot - 0.5 * n), 2.0);
    ASSERT_TRUE(cone);
    EXPECT_NEAR((cone->place - turned(foot)).norm(), 0.0, 1e-13);
    EXPECT_NEAR((cone->normal - turned(n)).norm(), 0.0, 1e-13);
    EXPECT_NEAR(cone->curvature, -along[0] / foot[1], 1e-13);
    EXPECT_NEAR(cone->distance(turned(foot - 0.5 * n + 0.3 * along) - cone->place), -0.5, 1e-13);
  }
}

}  // namespace
