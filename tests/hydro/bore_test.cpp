// Round bores a few particles across: they run full, and nothing bounces off their walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

using Corners = std::vector<std::array<double, 2>>;

// Fluid in an outline turned about the x axis, 1 apart, through solid walls; 2 m/s is the speed on the axis of a bore
// of radius R with mean velocity 1.
scene::Scene bore_scene(double length, double half_width, double viscosity, const Corners& outline) {
  auto scene = box_scene(3, length, 1.0, viscosity);
  for (int a = 1; a < 3; ++a) {
    scene.domain.lower[std::size_t(a)] = -half_width;
    scene.domain.upper[std::size_t(a)] = half_width;
  }
  scene.domain.material = 1;
  scene.materials.push_back({"wall", scene::MaterialType::wall, 0.0, 0.0, 0.0, {}, {}});
  scene.regions.push_back({std::make_shared<scene::Shape>(scene::Shape{scene::PolygonShape{outline}}), 0, {}});
  scene.effects.bounce_back = true;
  scene.numerics.reach = 2.6;
  scene.numerics.courant = 0.4;
  scene.flow.reference_speed = 2.0;
  return scene;
}

scene::Scene pipe_scene(double radius, double reynolds) {
  const double nu = 2.0 * radius / reynolds;
  auto scene = bore_scene(8.0, std::ceil(radius) + 2.0, nu, {{-50, 0}, {-50, radius}, {50, radius}, {50, 0}});
  scene.parameters["R"] = radius;
  scene.flow.initial_velocity = {{0.0, "2*(1-(y^2+z^2)/R^2)"}, {0.0, ""}, {0.0, ""}};
  scene.flow.body_force = scene::Point{8.0 * nu / (radius * radius), 0.0, 0.0};
  return scene;
}

// A tube of radius 4 that narrows to a throat of radius 2 from x = 18 on, at Re = 500.
scene::Scene cone_scene() {
  auto scene = bore_scene(34.0, 6.0, 0.008, {{-50, 0}, {-50, 4}, {6, 4}, {18, 2}, {100, 2}, {100, 0}});
  const std::string u = "2*2^2/r^2*(1-(y^2+z^2)/r^2)";
  const auto with = [&](const std::string& r) {
    std::string formula = u;
    for (std::size_t at = 0; (at = formula.find('r', at)) != std::string::npos; at += r.size())
      formula.replace(at, 1, r);
    return std::vector<scene::Quantity>{{0.0, formula}, {0.0, ""}, {0.0, ""}};
  };
  auto& x = scene.domain.sides[0];
  x[0].type = scene::SideType::inlet;
  x[0].inflow = with("4");
  x[1].type = scene::SideType::outlet;
  x[1].pressure = 0.0;
  scene.flow.initial_velocity = with("(x < 6 ? 4 : x < 18 ? 4-(x-6)/6 : 2)");
  scene.flow.reference_length = 4.0;
  scene.run.until = 100.0;
  return scene;
}

struct Stretch {
  double per_length = 0, passing = 0;  // particles [1/m], and how many pass a cross-section [1/s]
};

Stretch between(const Fluid<3>& fluid, double from, double to) {
  Stretch found;
  double count = 0.0, sum = 0.0;
  for (const auto i : fluid.state().rows.fluid()) {
    if (fluid.particles().position[i][0] < from || fluid.particles().position[i][0] >= to) continue;
    count += 1.0;
    sum += fluid.velocity(i)[0] + (*fluid.state().shift)[i][0];
  }
  return {count / (to - from), sum / (to - from)};
}

bool is_tied(const Fluid<3>& fluid) {
  const auto names = fluid.effects();
  return std::count(names.begin(), names.end(), DensityTie<3>::name) == 1;
}

}  // namespace

// Poiseuille's law, u = 2 (1 - r^2/R^2), where the particles are. Mirrored velocities left 41 % too much at 6 across
// and 13 % at 8; at 4 across, where nothing is fitted, 10 % are left.
TEST(Bores, FollowPoiseuilleFromSixParticlesAcrossOn) {
  for (const double radius : {3.0, 4.0}) {
    auto fluid = make_fluid<3>(pipe_scene(radius, 1.0));
    fluid.advance(2.0);  // five times as long as friction takes across
    double mean = 0.0, exact = 0.0;
    for (const auto i : fluid.state().rows.fluid()) {
      const auto& x = fluid.particles().position[i];
      mean += fluid.velocity(i)[0];
      exact += 2.0 * (1.0 - (x[1] * x[1] + x[2] * x[2]) / (radius * radius));
    }
    EXPECT_NEAR(mean / exact, 1.0, 0.025) << radius;
  }
}

TEST(Bores, StraightOnesLetNothingBounceAndKeepTheirDensity) {
  for (const double radius : {2.0, 3.0, 4.0}) {
    for (const double reynolds : {1.0, 500.0}) {
      auto fluid = make_fluid<3>(pipe_scene(radius, reynolds));
      fluid.advance(2.0);
      EXPECT_EQ(fluid.bounces(), 0U) << radius << " at Re = " << reynolds;
      EXPECT_LT(fluid.density_error(), 0.01) << radius << " at Re = " << reynolds;
    }
  }
}

// Left to continuity, half as much again passed the throat by then, as the tube before it ran empty, and in the end
// three times as fast; and particles that the transport velocity pushed on into the cone bounced in every step.
TEST(Bores, AThroatFourParticlesWideRunsFullBehindItsCone) {
  auto fluid = make_fluid<3>(cone_scene());
  const double start = between(fluid, 20.0, 32.0).per_length;
  ASSERT_NEAR(start, 12.0, 1e-9) << "lattice points of a circle of area 4 pi";
  EXPECT_TRUE(is_tied(fluid));
  fluid.advance(10.0);
  Stretch mean;
  for (int k = 1; k <= 10; ++k) {
    fluid.advance(10.0 + 0.4 * k);
    const auto now = between(fluid, 20.0, 32.0);
    mean.per_length += now.per_length / 10;
    mean.passing += now.passing / 10;
  }
  const double flux = 4.0 * std::numbers::pi;
  EXPECT_NEAR(mean.per_length, start, 0.05 * start);
  EXPECT_NEAR(mean.passing, flux, 0.1 * flux) << "of it 0.05 that a tube of 900 within its band may lose by now";
  EXPECT_LT(fluid.density_error(), 0.03);
  EXPECT_LT(fluid.bounces(), 500U) << "of 1000 particles in 700 steps";
}

TEST(Bores, DensityIsTiedOnlyWhereKernelsSumOverWallsInside) {
  EXPECT_TRUE(is_tied(make_fluid<3>(pipe_scene(3.0, 1.0))));
  auto scene = pipe_scene(3.0, 1.0);
  scene.effects.transport_velocity = false;
  EXPECT_FALSE(is_tied(make_fluid<3>(scene))) << "particles go where their densities know";
  scene = pipe_scene(3.0, 1.0);
  scene.domain.material = -1;
  scene.regions.insert(
      scene.regions.begin(),
      {std::make_shared<scene::Shape>(scene::Shape{scene::PolygonShape{{{-50, 0}, {-50, 4.2}, {50, 4.2}, {50, 0}}}}),
       1,
       {}});
  EXPECT_FALSE(is_tied(make_fluid<3>(scene))) << "kernels reach through the wall into nothing";
  const auto names = make_fluid<2>(cavity_scene(12, 100)).effects();
  EXPECT_EQ(std::count(names.begin(), names.end(), DensityTie<2>::name), 0) << "no wall inside, no open side";
}

}  // namespace shmoo::hydro::testing
