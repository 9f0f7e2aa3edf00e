// The sketch of the yeast cell in a pheromone gradient, read whole.
#include <gtest/gtest.h>

#include "scene/read.hpp"

namespace shmoo::scene {
namespace {

const std::string sketch_file = SHMOO_SOURCE_DIR "/tests/data/yeast-sketch.toml";

TEST(Sketch, IsReadAsItIsMeant) {
  const Scene scene = read_scene(sketch_file);
  EXPECT_EQ(scene.title, "Alpha-factor gradient past a yeast cell in a Y-chamber");
  EXPECT_EQ(scene.dimension, 2);
  EXPECT_DOUBLE_EQ(scene.depth, 1e-6);
  EXPECT_DOUBLE_EQ(scene.domain.upper[0], 200e-6);
  EXPECT_DOUBLE_EQ(scene.domain.upper[1], 100e-6);
  EXPECT_DOUBLE_EQ(scene.domain.spacing, 1e-6);
  EXPECT_EQ(scene.domain.sides[0][0].type, SideType::periodic);
  EXPECT_EQ(scene.domain.sides[0][1].type, SideType::periodic);
  EXPECT_EQ(scene.domain.sides[1][0].type, SideType::wall);
  ASSERT_EQ(scene.materials.size(), 3u);
  EXPECT_EQ(scene.materials[0].name, "cell");
  EXPECT_EQ(scene.materials[1].name, "medium");
  EXPECT_EQ(scene.materials[2].name, "membrane");
  EXPECT_EQ(scene.materials[1].type, MaterialType::fluid);
  EXPECT_DOUBLE_EQ(scene.materials[1].viscosity, 1e-3);
  EXPECT_EQ(scene.domain.material, 1);
  ASSERT_EQ(scene.regions.size(), 2u);
  EXPECT_EQ(scene.regions[0].material, 0);
  EXPECT_EQ(scene.regions[1].material, 2);
  const auto& ring = std::get<ShellShape>(scene.regions[1].shape->form);
  EXPECT_DOUBLE_EQ(ring.inner, 1.5e-6);
  EXPECT_DOUBLE_EQ(ring.outer, 2.5e-6);
}

TEST(Sketch, HasItsChemistry) {
  const Scene scene = read_scene(sketch_file);
  ASSERT_EQ(scene.species.size(), 3u);
  EXPECT_EQ(scene.species[0].name, "L");
  EXPECT_EQ(scene.species[0].homes, (std::vector{1, 2}));
  EXPECT_DOUBLE_EQ(scene.species[0].diffusivity, 347e-12);
  EXPECT_EQ(scene.species[1].homes, (std::vector{2}));
  ASSERT_EQ(scene.initials.size(), 1u);
  EXPECT_EQ(scene.initials[0].species, 1);
  EXPECT_DOUBLE_EQ(scene.initials[0].concentration.value, 1e20);
  ASSERT_EQ(scene.reactions.size(), 2u);
  EXPECT_EQ(scene.reactions[0].name, "R + L <-> RL (forward)");
  EXPECT_DOUBLE_EQ(scene.reactions[0].rate_constant, 6.022e6 / 6.02214076e26);
  EXPECT_DOUBLE_EQ(scene.reactions[1].rate_constant, 1);
  ASSERT_EQ(scene.reactions[0].reactants.size(), 2u);
  EXPECT_EQ(scene.reactions[0].reactants[0].species, 0);
  ASSERT_EQ(scene.reactions[0].products.size(), 1u);
  EXPECT_EQ(scene.reactions[0].products[0].species, 2);
}

TEST(Sketch, HasItsFlow) {
  const Scene scene = read_scene(sketch_file);
  ASSERT_EQ(scene.inflows.size(), 2u);
  EXPECT_DOUBLE_EQ((*scene.inflows[0].velocity)[0], 250e-6);
  for (const auto& inflow : scene.inflows) {
    ASSERT_EQ(inflow.species.size(), 1u);
    EXPECT_EQ(inflow.species[0].first, 0);
  }
  EXPECT_DOUBLE_EQ(scene.inflows[0].species[0].second, 1e20);
  EXPECT_EQ(scene.inflows[1].species[0].second, 0);
  EXPECT_TRUE(scene.effects.flow);
  EXPECT_TRUE(scene.effects.viscosity);
  EXPECT_TRUE(scene.effects.bounce_back);
  EXPECT_TRUE(scene.effects.species_advection);
  EXPECT_FALSE(scene.effects.thermal_noise);
  EXPECT_DOUBLE_EQ(scene.run.until, 0.8);
  EXPECT_DOUBLE_EQ(scene.run.record_every, 0.01);
  EXPECT_EQ(scene.run.realisations, 100);
  EXPECT_EQ(scene.run.seed, 20180u);
}

}  // namespace
}  // namespace shmoo::scene
