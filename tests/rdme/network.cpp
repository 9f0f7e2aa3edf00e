// What the network makes of a scene: who is sampled, where a reaction runs, what depends on what, what is refused.
#include "rdme/network.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "lattice.hpp"

namespace shmoo::rdme {
namespace {

std::vector<int> list(std::span<const int> values) { return {values.begin(), values.end()}; }

// Water (0) and membrane (1): L lives in both, R and RL in the membrane.
scene::Scene receptor() {
  scene::Scene scene = water();
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "membrane";
  scene.species = {{"L", {0, 1}, 1.0, scene::SpeciesMethod::stochastic},
                   {"R", {1}, 0.0, scene::SpeciesMethod::stochastic},
                   {"RL", {1}, 0.0, scene::SpeciesMethod::stochastic},
                   {"D", {0, 1}, 1.0, scene::SpeciesMethod::deterministic}};
  add_reaction(scene, "binding", {{0, 1}, {1, 1}}, {{2, 1}}, 1.0);
  add_reaction(scene, "unbinding", {{2, 1}}, {{0, 1}, {1, 1}}, 1.0);
  add_reaction(scene, "loss of L", {{0, 1}}, {}, 1.0);
  add_reaction(scene, "loss of D", {{3, 1}, {0, 1}}, {{0, 1}}, 1.0);
  add_reaction(scene, "catalysis", {{3, 1}}, {{3, 1}, {0, 1}}, 0, "D*(1 + R + t)");
  return scene;
}

TEST(Network, SamplesWhatChangesAStochasticSpecies) {
  const Network network(receptor());
  EXPECT_EQ(list(network.sampled_in(1)), (std::vector{0, 1, 2, 4}));
  EXPECT_EQ(list(network.sampled_in(0)), (std::vector{2}));  // the catalysis reads R, which does not live in water
  EXPECT_EQ(list(network.integrated_in(0)), (std::vector{3}));
  EXPECT_TRUE(network.sampled_rates_change_in_time());
}

TEST(Network, KnowsWhatDependsOnWhat) {
  const Network network(receptor());
  EXPECT_EQ(list(network.after_species(0, 1)), (std::vector{0, 2}));
  EXPECT_EQ(list(network.after_species(1, 1)), (std::vector{0, 4}));
  EXPECT_EQ(list(network.after_species(3, 1)), (std::vector{4}));
  EXPECT_EQ(list(network.after_reaction(0, 1)), (std::vector{0, 1, 2, 4}));
  EXPECT_EQ(list(network.after_reaction(2, 1)), (std::vector{0, 2}));
  EXPECT_EQ(list(network.after_species(0, 0)), (std::vector{2}));
}

TEST(Network, RefusesAllMistakesAtOnce) {
  scene::Scene scene = receptor();
  scene.reactions[0].materials = {0};
  add_reaction(scene, "unknown name", {{0, 1}}, {}, 0, "k*L");
  add_reaction(scene, "bad text", {{0, 1}}, {}, 0, "2*(L");
  add_reaction(scene, "negative", {{0, 1}}, {}, -1.0);
  try {
    const Network network(scene);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 4U);
    EXPECT_NE(error.diagnostics()[0].message.find("material water, where species R"), std::string::npos);
  }
}

TEST(Network, RefusesAReactionThatCanRunNowhere) {
  scene::Scene scene = receptor();
  scene.species[1].homes = {0};
  EXPECT_THROW(Network{scene}, base::InputError);
}

}  // namespace
}  // namespace shmoo::rdme
