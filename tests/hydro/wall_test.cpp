// Walls: nothing passes them, whether they rest, move or are thin, and they carry out the motions that they are given.
#include <gtest/gtest.h>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

constexpr int across = 20;  // spacings

// A box with a slab of wall in the middle of x, of the given number of layers, and fluid on both sides.
scene::Scene slab_scene(int layers) {
  auto scene = box_scene(2, 1.0, 1.0 / across, 0.01);
  scene.domain.upper[1] = 0.5;
  scene.materials.push_back({"slab", scene::MaterialType::wall, 0, 0, 0, {}, {}});
  const double spacing = 1.0 / across;
  scene::BoxShape box{{0.5, 0.0, 0.0}, {0.5 + layers * spacing, 0.5, 0.0}};
  scene.regions.push_back({std::make_shared<scene::Shape>(scene::Shape{box}), 1, {}});
  scene.effects.bounce_back = true;
  scene.flow.reference_speed = 1.0;
  return scene;
}

// The fluid particle nearest to a place.
std::size_t nearest(const Fluid<2>& fluid, const base::Vec<2>& place) {
  std::size_t best = fluid.state().rows.fluid().front();
  for (const auto i : fluid.state().rows.fluid()) {
    const auto& x = fluid.particles().position;
    if ((x[i] - place).squaredNorm() < (x[best] - place).squaredNorm()) best = i;
  }
  return best;
}

// Shoots one particle at the slab from the left, with up to the speed of sound and at an angle; returns the furthest
// that any particle of the left half got into the slab, in spacings beyond its surface, while `slab` gives the
// surface's place.
struct Shot {
  double deepest = -1e9;
  std::uint64_t bounces = 0;
};

Shot shoot(const scene::Scene& scene, const base::Vec<2>& velocity, double surface_speed = 0.0) {
  auto fluid = make_fluid<2>(scene);
  const auto bullet_id = fluid.particles().id[nearest(fluid, {0.5 - 1.5 / across, 0.25})];
  const auto find = [&] {
    std::size_t i = 0;
    while (fluid.particles().id[i] != bullet_id) ++i;
    return i;
  };
  fluid.particles().template require<base::Vec<2>>("velocity", "m/s")[find()] = velocity;
  fluid.restart();
  Shot shot;
  while (fluid.time() < 0.2) {
    fluid.step();
    const double surface = 0.5 + surface_speed * fluid.time();
    shot.deepest = std::max(shot.deepest, (fluid.particles().position[find()][0] - surface) * across);
  }
  shot.bounces = fluid.bounces();
  return shot;
}

// A stream past a cylinder with ten particles across, whose boundary layer is thinner than the kernel's reach.
double worst_density_of_a_stream(scene::WallForm walls, std::uint64_t& bounces) {
  auto scene = box_scene(2, 6.0, 0.1, 0.01);
  scene.domain.upper[1] = 4.0;
  scene.materials.push_back({"cylinder", scene::MaterialType::wall, 0, 0, 0, {}, {}});
  scene.regions.push_back(
      {std::make_shared<scene::Shape>(scene::Shape{scene::BallShape{{2.0, 2.0, 0.0}, 0.5}}), 1, {}});
  scene.effects.bounce_back = true;
  scene.flow.initial_velocity = {{1.0, ""}, {0.0, ""}};
  scene.flow.reference_speed = 1.5;
  scene.numerics.walls = walls;
  auto fluid = make_fluid<2>(scene);
  fluid.advance(1.5);  // the sound of the sudden start has passed
  double worst = 0.0;
  for (int k = 0; k < 20; ++k) {
    fluid.advance(1.5 + 0.1 * (k + 1));
    for (const auto i : fluid.state().rows.fluid()) worst = std::max(worst, std::abs(fluid.state().density[i] - 1.0));
  }
  bounces = fluid.bounces();
  return worst;
}

TEST(Walls, AThinBoundaryLayerIsNotTakenForAParabola) {
  std::uint64_t bounces = 0, fitted_bounces = 0;
  const double careful = worst_density_of_a_stream(scene::WallForm::automatic, bounces);
  const double fitted = worst_density_of_a_stream(scene::WallForm::second_order, fitted_bounces);
  EXPECT_LT(careful, 0.03);
  EXPECT_LT(careful, 0.8 * fitted);
  EXPECT_LE(bounces, 2u);
}

}  // namespace

class Slabs : public ::testing::TestWithParam<int> {};

TEST_P(Slabs, AShotParticleDoesNotPass) {
  for (const double angle : {0.0, 0.6}) {
    const auto shot = shoot(slab_scene(GetParam()), 10.0 * base::Vec<2>(std::cos(angle), std::sin(angle)));
    EXPECT_LT(shot.deepest, 0.5) << "angle " << angle;
    EXPECT_GT(shot.bounces, 0u) << "angle " << angle;
  }
}
INSTANTIATE_TEST_SUITE_P(Layers, Slabs, ::testing::Values(1, 2, 6));

TEST(MovingWall, AShotParticleDoesNotPassIt) {
  auto scene = slab_scene(6);
  scene.materials[1].motion = scene::RigidMotion{{-0.5, 0.0, 0.0}, {}, {}};
  const auto shot = shoot(scene, {10.0, 0.0}, -0.5);
  EXPECT_LT(shot.deepest, 0.5);
  EXPECT_GT(shot.bounces, 0u);
}

TEST(MovingWall, PushesTheFluidAlong) {
  auto scene = slab_scene(6);
  scene.materials[1].motion = scene::RigidMotion{{0.5, 0.0, 0.0}, {}, {}};
  auto fluid = make_fluid<2>(scene);
  fluid.advance(0.6);
  // Periodic along x: the fluid can only travel with the slab.
  double mean = 0.0;
  for (const auto i : fluid.state().rows.fluid()) mean += fluid.velocity(i)[0];
  EXPECT_NEAR(mean / double(fluid.state().rows.fluid().size()), 0.5, 0.1);
}

TEST(WallMotion, ARigidMotionTurnsAndTravels) {
  scene::Scene scene;
  scene.materials.resize(1);
  scene.materials[0].motion = scene::RigidMotion{{1.0, 0.0, 0.0}, {0.0, 0.0, 2.0}, {0.5, 0.5, 0.0}};
  const WallMotion<2> motion(scene);
  base::Vec<2> x(0.7, 0.5);
  for (int k = 0; k < 100; ++k) x = motion.carry(0, x, 0.01 * k, 0.01);
  EXPECT_NEAR(x[0], 1.5 + 0.2 * std::cos(2.0), 1e-13);
  EXPECT_NEAR(x[1], 0.5 + 0.2 * std::sin(2.0), 1e-13);
  const auto v = motion.surface_velocity(0, x, 1.0);
  EXPECT_NEAR(v[0], 1.0 - 0.4 * std::sin(2.0), 1e-13);
  EXPECT_NEAR(v[1], 0.4 * std::cos(2.0), 1e-13);
  EXPECT_NEAR(motion.acceleration(0, x, 1.0).norm(), 4.0 * 0.2, 1e-13);
}

// A disk whose surface slides round drags the fluid; its particles stay.
TEST(SurfaceMotion, SlidesWithoutMovingParticles) {
  auto scene = box_scene(2, 1.0, 1.0 / 20, 0.1);
  scene.materials.push_back(
      {"roll", scene::MaterialType::wall, 0, 0, 0, {}, scene::RigidMotion{{}, {0, 0, 1}, {0.5, 0.5, 0}}});
  scene.regions.push_back({std::make_shared<scene::Shape>(scene::Shape{scene::BallShape{{0.5, 0.5, 0}, 0.2}}), 1, {}});
  scene.effects.bounce_back = true;
  auto fluid = make_fluid<2>(scene);
  const auto filling = sph::fill<2>(scene);
  fluid.advance(0.3);
  double swirl = 0.0;
  for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
    const auto& x = fluid.particles().position[i];
    if (fluid.particles().role[i] == sph::Role::wall) {
      ASSERT_EQ(x, filling.particles.position[fluid.particles().id[i]]);
    } else {
      const auto v = fluid.velocity(i);
      swirl += (x[0] - 0.5) * v[1] - (x[1] - 0.5) * v[0];
    }
  }
  EXPECT_GT(swirl, 0.0);
}

// Gels and slabs of pure chemistry are walls to a fluid that touches them.
TEST(StillMaterial, ActsAsARestingWall) {
  auto as_wall = slab_scene(6), as_still = slab_scene(6);
  as_still.materials[1].type = scene::MaterialType::still;
  as_wall.flow.body_force = as_still.flow.body_force = scene::Point{0.0, 0.5, 0.0};
  auto wall = make_fluid<2>(as_wall), still = make_fluid<2>(as_still);
  wall.advance(0.2);
  still.advance(0.2);
  EXPECT_GT(wall.kinetic_energy(), 0.0);
  EXPECT_EQ(wall.kinetic_energy(), still.kinetic_energy());
}

}  // namespace shmoo::hydro::testing
