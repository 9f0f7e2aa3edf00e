// SBML networks as model files.
#include "scene/sbml/import.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.hpp"
#include "scene/document.hpp"
#include "scene/expression.hpp"
#include "scene/read.hpp"
#include "scene/sbml/export.hpp"

namespace shmoo::scene {
namespace {

const std::string folder = SHMOO_SOURCE_DIR "/tests/data/sbml/";

Scene imported(const std::string& name) {
  const std::string file = folder + name + ".xml";
  return read_scene_text(import_sbml(read_bytes(file), file), name + ".toml");
}

std::string refusal(const std::string& name) {
  try {
    imported(name);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Sbml, BirthAndDeathIsReadAsItIsMeant) {
  const Scene scene = imported("birth-death");
  ASSERT_EQ(scene.species.size(), 1u);
  EXPECT_EQ(scene.initials[0].count, 100);
  ASSERT_EQ(scene.reactions.size(), 2u);
  EXPECT_EQ(scene.reactions[0].name, "birth");
  EXPECT_TRUE(scene.reactions[0].reactants.empty());  // X -> 2 X on balance
  EXPECT_EQ(scene.reactions[0].expression, "lambda * X");
  EXPECT_FALSE(scene.reactions[0].per_volume);
  EXPECT_EQ(scene.parameters.at("mu"), 0.11);
  ASSERT_EQ(scene.observables.size(), 1u);
  EXPECT_EQ(scene.observables[0].name, "X");
}

TEST(Sbml, ConcentrationsLocalParametersAndFunctions) {
  const Scene scene = imported("birth-death-concentration");
  EXPECT_EQ(scene.initials[0].count, 100);
  EXPECT_EQ(scene.reactions[0].expression, "cell * (lambda * (X / cell))");
  EXPECT_EQ(scene.reactions[1].expression, "cell * death_mu * (X / cell)");
  EXPECT_EQ(scene.parameters.at("death_mu"), 0.11);
  EXPECT_EQ(scene.parameters.at("mu"), 99);
  ASSERT_EQ(scene.definitions.size(), 1u);
  EXPECT_EQ(scene.definitions[0].name, "Food");
}

TEST(Sbml, LevelsAndVersionsThatAskForNoPackageAreRead) {
  const Scene two = imported("level-2-dimerisation");
  EXPECT_EQ(two.species.size(), 2u);
  const Scene three = imported("level-3-2-transport");
  EXPECT_EQ(three.compartments.size(), 2u);
  EXPECT_EQ(three.events.size(), 1u);
}

TEST(Sbml, NamesOfAxesAreFreeWhereThereIsNoPlace) {
  const Scene scene = imported("rule-for-y");
  const auto y = std::find_if(scene.definitions.begin(), scene.definitions.end(),
                              [](const Definition& one) { return one.name == "y"; });
  ASSERT_NE(y, scene.definitions.end());
  EXPECT_EQ(y->expression, "2 * (X / cell)");
}

TEST(Sbml, RulesInitialAssignmentsAndEvents) {
  const Scene rule = imported("immigration-death-rule");
  EXPECT_EQ(rule.initials[0].count, 5);
  ASSERT_EQ(rule.definitions.size(), 1u);
  EXPECT_EQ(rule.definitions[0].expression, "2 * X");
  const Scene reset = imported("immigration-death-reset");
  ASSERT_EQ(reset.events.size(), 1u);
  EXPECT_EQ(reset.events[0].trigger, "t >= 25");
  EXPECT_EQ(reset.events[0].assignments[0].expression, "50");
}

// 0.5 zmol/fL in 2 fL are 602.214076 molecules, as a concentration; a rate in zmol/min becomes events per second.
TEST(Sbml, UnitsThatAreDeclaredCount) {
  const Scene scene = imported("level-2-moles");
  EXPECT_DOUBLE_EQ(scene.compartments[0].volume, 2e-18);
  EXPECT_NEAR(scene.initials[1].concentration.value * 2e-18, 602.214076, 1e-9);
  EXPECT_EQ(scene.initials[0].count, 0);
  const std::vector<std::string> names{"cell", "k", "S"};
  const Expression decay(scene.reactions[0].expression, names);
  EXPECT_DOUBLE_EQ(decay({2, 0.3, 600}), 0.3 * 600 / 60);
  ASSERT_EQ(scene.events.size(), 1u);
  EXPECT_DOUBLE_EQ(Expression(scene.events[0].trigger, {"t"})({120.0}), 0.0);
  EXPECT_DOUBLE_EQ(Expression(scene.events[0].trigger, {"t"})({120.1}), 1.0);
  EXPECT_DOUBLE_EQ(Expression(scene.events[0].delay, {})({}), 60.0);
  // 1 zmol/fL more
  EXPECT_NEAR(Expression(scene.events[0].assignments[0].expression, {"cell", "S"})({2, 100}), 1304, 1.0);
}

TEST(Sbml, WhatIsNotSupportedIsNamed) {
  EXPECT_NE(refusal("refused-rate-rule").find("rate rules are not supported; it is for 'y'"), std::string::npos);
  EXPECT_NE(refusal("refused-fast").find("'immigration': fast reactions are not supported"), std::string::npos);
  EXPECT_NE(refusal("refused-rate-rule").find("refused-rate-rule.xml:"), std::string::npos);
  EXPECT_THROW(import_sbml("no XML at all", "a.xml"), base::InputError);
  EXPECT_THROW(import_sbml("", "a.xml"), base::InputError);
}

// What is written is read back as the same: reactions, rates at some numbers, events, amounts.
TEST(Sbml, GoesOutAndBackUnchanged) {
  for (const char* name : {"birth-death", "dimerisation", "batch-immigration-death", "immigration-death-reset",
                           "immigration-death-rule"}) {
    const Scene before = imported(name);
    const Scene after =
        read_scene_text(import_sbml(export_sbml(before, {*before.initials[0].count, 0}, 1), name), name);
    ASSERT_EQ(after.reactions.size(), before.reactions.size()) << name;
    for (std::size_t r = 0; r < before.reactions.size(); ++r) {
      EXPECT_EQ(after.reactions[r].name, before.reactions[r].name);
      EXPECT_EQ(after.reactions[r].expression, before.reactions[r].expression);
      EXPECT_EQ(after.reactions[r].reactants.size(), before.reactions[r].reactants.size());
    }
    EXPECT_EQ(after.initials[0].count, before.initials[0].count);
    ASSERT_EQ(after.events.size(), before.events.size());
    for (std::size_t e = 0; e < before.events.size(); ++e) {
      EXPECT_EQ(after.events[e].trigger, before.events[e].trigger);
      EXPECT_EQ(after.events[e].assignments[0].expression, before.events[e].assignments[0].expression);
    }
    EXPECT_EQ(after.definitions.size(), before.definitions.size());
  }
}

}  // namespace
}  // namespace shmoo::scene
