// Open sides: what enters leaves, a profile keeps its shape, no void opens, no id is given twice.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>
#include <set>

#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

// Fluid that enters at the left of a channel `across` spacings and 1 m wide, twice as long, and leaves at the right.
scene::Scene open_scene(int across, const std::string& inflow, double viscosity, scene::SideType beside) {
  auto scene = box_scene(2, 1.0, 1.0 / across, viscosity);
  scene.domain.upper[0] = 2.0;
  auto& x = scene.domain.sides[0];
  x[0].type = scene::SideType::inlet;
  x[0].inflow = {{0.0, inflow}, {0.0, ""}};
  x[1].type = scene::SideType::outlet;
  x[1].pressure = 0.0;
  for (auto& side : scene.domain.sides[1]) side.type = beside;
  scene.effects.bounce_back = scene::has_friction(beside);
  scene.flow.initial_velocity = scene.domain.sides[0][0].inflow;
  scene.flow.reference_speed = 1.0;
  scene.run.until = 100.0;
  return scene;
}

const std::string parabola = "4*y*(1-y)";

// The largest deviation of the velocity along x from `u(y)`, of particles away from the ends.
template <class Profile>
double deviation(const Fluid<2>& fluid, const Profile& u) {
  double largest = 0.0;
  for (const auto i : fluid.state().rows.fluid()) {
    const auto& x = fluid.particles().position[i];
    largest = std::max(largest, std::abs(fluid.velocity(i)[0] - u(x[1])));
  }
  return largest;
}

template <class Profile>
double root_mean_square(const Fluid<2>& fluid, const Profile& u) {
  double sum = 0.0;
  for (const auto i : fluid.state().rows.fluid())
    sum += std::pow(fluid.velocity(i)[0] - u(fluid.particles().position[i][1]), 2);
  return std::sqrt(sum / double(fluid.state().rows.fluid().size()));
}

double mean_pressure(const Fluid<2>& fluid) {
  double sum = 0.0;
  for (const auto i : fluid.state().rows.fluid()) sum += fluid.state().pressure[i];
  return sum / double(fluid.state().rows.fluid().size());
}

// The largest distance, in spacings, of any point of a grid inside the domain from its nearest fluid particle.
double largest_void(const Fluid<2>& fluid) {
  const double spacing = fluid.scales().spacing;
  double largest = 0.0;
  for (double x = 0.5 * spacing; x < fluid.box().upper[0]; x += spacing) {
    for (double y = 0.5 * spacing; y < fluid.box().upper[1]; y += spacing) {
      double nearest = 1e9;
      for (const auto i : fluid.state().rows.fluid())
        nearest = std::min(nearest, (fluid.particles().position[i] - base::Vec<2>(x, y)).squaredNorm());
      largest = std::max(largest, nearest);
    }
  }
  return std::sqrt(largest) / spacing;
}

}  // namespace

TEST(OpenSides, AUniformStreamPassesUntouched) {
  auto fluid = make_fluid<2>(open_scene(10, "1", 0.01, scene::SideType::slip));
  const std::size_t start = fluid.state().rows.fluid().size();
  fluid.advance(6.0);  // three times through
  EXPECT_LT(deviation(fluid, [](double) { return 1.0; }), 1e-9);
  EXPECT_LT(fluid.density_error(), 1e-9);
  EXPECT_NEAR(double(fluid.state().rows.fluid().size()), double(start), 10.0);
  EXPECT_NEAR(double(fluid.open_sides()->entered()), 600.0, 20.0);
  EXPECT_NEAR(double(fluid.open_sides()->left()), 600.0, 20.0);
}

TEST(OpenSides, AUniformStreamPassesUntouchedIn3D) {
  auto scene = box_scene(3, 1.0, 1.0 / 6, 0.01);
  scene.domain.sides[2][0] = {scene::SideType::inlet, {}, {{0.0, "0"}, {0.0, "0"}, {0.0, "1"}}, {}};
  scene.domain.sides[2][1] = {scene::SideType::outlet, {}, {}, 0.0};
  for (auto& side : scene.domain.sides[1]) side.type = scene::SideType::slip;
  scene.flow.initial_velocity = scene.domain.sides[2][0].inflow;
  auto fluid = make_fluid<3>(scene);
  fluid.advance(3.0);
  double largest = 0.0;
  for (const auto i : fluid.state().rows.fluid())
    largest = std::max(largest, (fluid.velocity(i) - base::Vec<3>(0, 0, 1)).norm());
  EXPECT_LT(largest, 1e-9);
  EXPECT_NEAR(double(fluid.open_sides()->entered()), 3.0 * 6 * 36, 72.0);
}

TEST(OpenSides, AParabolaKeepsItsProfile) {
  const auto u = [](double y) { return 4.0 * y * (1.0 - y); };
  auto fluid = make_fluid<2>(open_scene(20, parabola, 0.1, scene::SideType::wall));
  fluid.advance(4.0);
  const double early = mean_pressure(fluid), start = double(fluid.state().rows.fluid().size());
  const auto in = fluid.open_sides()->entered(), out = fluid.open_sides()->left();
  fluid.advance(10.0);
  EXPECT_LT(root_mean_square(fluid, u), 0.01);
  EXPECT_NEAR(mean_pressure(fluid), early, 0.02 * early) << "of 8 eta U l/(2 w^2) = 0.8 Pa";
  EXPECT_NEAR(early, 0.8, 0.05);
  const double entered = double(fluid.open_sides()->entered() - in), left = double(fluid.open_sides()->left() - out);
  EXPECT_NEAR(entered, 6.0 * 2.0 / 3.0 * 400, 0.01 * 1600) << "particles of a 400th each";
  EXPECT_NEAR(left, entered, 0.01 * entered + 10.0);
  EXPECT_NEAR(double(fluid.state().rows.fluid().size()), start, 20.0) << "a column";
  EXPECT_LT(largest_void(fluid), 1.0);
  EXPECT_GT(fluid.smallest_distance(), 0.5);
}

TEST(OpenSides, PressuresDriveTheFlowOfAChannel) {
  auto scene = open_scene(20, "", 0.1, scene::SideType::wall);
  scene.domain.sides[0][0].inflow.clear();
  scene.domain.sides[0][0].pressure = 1.6;  // 8 eta U l/w^2 with U = 1
  scene.flow.initial_velocity.clear();
  auto fluid = make_fluid<2>(scene);
  fluid.advance(15.0);
  EXPECT_LT(root_mean_square(fluid, [](double y) { return 4.0 * y * (1.0 - y); }), 0.02);
  EXPECT_NEAR(mean_pressure(fluid), 0.8, 0.02);
}

TEST(OpenSides, AnInletMayPulsateAndReverse) {
  auto scene = open_scene(10, "sin(2*_pi*t/4)", 0.01, scene::SideType::slip);
  scene.flow.sound_speed = 40.0;
  auto fluid = make_fluid<2>(scene);
  const double start = double(fluid.state().rows.fluid().size());
  std::set<std::uint32_t> before, gone;
  for (int k = 1; k <= 40; ++k) {
    fluid.advance(0.2 * k);
    std::set<std::uint32_t> now, places;
    for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
      EXPECT_TRUE(now.insert(fluid.particles().id[i]).second);
      const auto place = fluid.places()->of(i);
      EXPECT_TRUE(place == no_place || places.insert(place).second);
    }
    for (const auto id : before)
      if (!now.contains(id)) gone.insert(id);
    for (const auto id : now) EXPECT_FALSE(gone.contains(id)) << "an id came back";
    before = std::move(now);
    EXPECT_NEAR(double(fluid.state().rows.fluid().size()), start, 0.06 * start);
  }
  EXPECT_LT(deviation(fluid, [](double) { return 0.0; }), 0.1);
  EXPECT_GT(fluid.open_sides()->entered(), 400U);
}

// The sound of a start that is too slow by a fifth: without damping it would ring between inlet and outlet.
TEST(OpenSides, SoundLeavesThroughTheOutlet) {
  auto scene = open_scene(10, "1", 0.0, scene::SideType::slip);
  scene.effects.viscosity = false;
  scene.flow.initial_velocity = {{0.8, ""}, {0.0, ""}};
  auto fluid = make_fluid<2>(scene);
  fluid.advance(0.2);  // one crossing
  EXPECT_GT(std::abs(mean_pressure(fluid)), 0.1);
  fluid.advance(4.0);
  EXPECT_LT(deviation(fluid, [](double) { return 1.0; }), 0.01);
  EXPECT_LT(std::abs(mean_pressure(fluid)), 0.05) << "of rho c0 du = 2 Pa";
}

TEST(OpenSides, HaveTheSameBitsForAnyNumberOfThreads) {
  std::vector<std::vector<double>> found;
  for (const int threads : {1, 2, 5}) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    auto fluid = make_fluid<2>(open_scene(50, parabola, 0.01, scene::SideType::wall));
    for (int k = 0; k < 60; ++k) fluid.step();
    omp_set_num_threads(before);
    EXPECT_GT(fluid.open_sides()->entered(), 0U);
    std::vector<double> values;
    for (std::size_t i = 0; i < fluid.particles().size(); ++i) {
      values.push_back(fluid.particles().id[i]);
      for (int a = 0; a < 2; ++a) {
        values.push_back(fluid.particles().position[i][a]);
        values.push_back(fluid.state().velocity[i][a]);
      }
    }
    found.push_back(std::move(values));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

TEST(OpenSides, AreAbsentWhereNoneIs) {
  auto fluid = make_fluid<2>(poiseuille_scene(10));
  EXPECT_EQ(fluid.open_sides(), nullptr);
  EXPECT_EQ(fluid.particles().find("place"), nullptr);
}

TEST(OpenSides, AFilledDomainSaysSo) {
  auto scene = open_scene(10, "1", 0.01, scene::SideType::slip);
  scene.domain.sides[0][1] = scene.domain.sides[0][0];
  scene.domain.sides[0][1].inflow[0].expression = "-1";
  auto fluid = make_fluid<2>(scene);
  EXPECT_THROW(fluid.advance(3.0), base::RunError);
}

}  // namespace shmoo::hydro::testing
