// A closed room: no volume passes its walls, not under the ends of a lid and not where walls strain, and it stays full.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "scene/read.hpp"
#include "scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

double mean_along_x(const Fluid<2>& fluid) {
  double sum = 0.0;
  for (const auto i : fluid.state().rows.fluid()) sum += fluid.velocity(i)[0];
  return sum / double(fluid.state().rows.fluid().size());
}

// Of what the fluid's volumes should fill.
double filled(const Fluid<2>& fluid) {
  double sum = 0.0;
  for (const auto i : fluid.state().rows.fluid()) sum += fluid.scales().density / fluid.state().density[i];
  return sum / double(fluid.state().rows.fluid().size());
}

}  // namespace

// Where particles stay on the whole where they are, a mean velocity that does not vanish passes through walls, and the
// transport velocity only brings the particles back. 0.018 was seen before corners knew each side's normal velocity.
TEST(ClosedRoom, NothingPassesTheWallsUnderTheEndsOfALid) {
  auto fluid = make_fluid<2>(cavity_scene(20, 100));
  double mean = 0.0;
  for (int k = 1; k <= 12; ++k) {
    fluid.advance(0.5 * k);
    if (k > 6) mean += mean_along_x(fluid) / 6;
  }
  EXPECT_NEAR(mean, 0.0, 0.004);
  EXPECT_NEAR(filled(fluid), 1.0, 1e-4) << "some 2e-6 a step between two looks; 6e-3 by now if none were taken";
}

// A fluid that is strained along with its walls is strained evenly: mean density rose by 2.5 % where walls mirrored all
// of its velocity.
TEST(ClosedRoom, DrawnOutAtConstantVolumeKeepsItsDensity) {
  const auto scene = scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/validation/isochoric-box/model.toml",
                                       {{"domain.spacing", "\"0.01 m\""}});
  auto fluid = make_fluid<2>(scene);
  fluid.advance(2.0);
  EXPECT_LT(fluid.density_error(), 0.005);
  fluid.advance(3.0);
  EXPECT_LT(fluid.density_error(), 1e-3);
}

TEST(ClosedRoom, IsNamedWhereTheFluidFillsItAndOnlyThere) {
  const auto named = [](const scene::Scene& scene) {
    const auto names = make_fluid<2>(scene).effects();
    return std::count(names.begin(), names.end(), "closed room") == 1;
  };
  EXPECT_TRUE(named(cavity_scene(20, 100)));
  auto scene = cavity_scene(20, 100);
  scene.effects.transport_velocity = false;
  EXPECT_FALSE(named(scene)) << "nothing makes density drift";
  scene = cavity_scene(20, 100);
  scene.effects.closed_room = false;
  EXPECT_FALSE(named(scene)) << "told off";
  scene = cavity_scene(20, 100);
  scene.domain.material = -1;
  scene.regions.push_back(
      {std::make_shared<scene::Shape>(scene::Shape{scene::BoxShape{{0.0, 0.0, 0.0}, {1.0, 0.5, 0.0}}}), 0, {}});
  EXPECT_FALSE(named(scene)) << "half of the cavity is empty";
}

}  // namespace shmoo::hydro::testing
