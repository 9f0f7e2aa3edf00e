#include "rdme/mass_action.hpp"

#include <gtest/gtest.h>

namespace shmoo::rdme {
namespace {

const std::vector<std::string> species{"A", "B"};
const std::vector<std::pair<std::string, double>> parameters{{"k", 3.0}, {"V", 2.0}};

TEST(MassAction, IsSeenThroughItsWriting) {
  const auto expect = [](const char* formula, double constant, std::vector<scene::Term> reactants) {
    const auto law = as_mass_action(formula, species, parameters);
    ASSERT_TRUE(law) << formula;
    EXPECT_DOUBLE_EQ(law->constant, constant) << formula;
    ASSERT_EQ(law->reactants.size(), reactants.size()) << formula;
    for (std::size_t k = 0; k < reactants.size(); ++k) {
      EXPECT_EQ(law->reactants[k].species, reactants[k].species) << formula;
      EXPECT_EQ(law->reactants[k].count, reactants[k].count) << formula;
    }
  };
  expect("k", 3.0, {});
  expect("k*A", 3.0, {{0, 1}});
  expect("A*(B/V)*k", 1.5, {{0, 1}, {1, 1}});
  expect("k*A*(A - 1)/2", 1.5, {{0, 2}});
  expect("0.5*k*(A - 1)*A", 1.5, {{0, 2}});
  expect("B*(B-1)*(B-2)*k/(V*3)", 0.5, {{1, 3}});
  expect("V*(k*(A/V)*(B/V))", 1.5, {{0, 1}, {1, 1}});
  expect("sqrt(k + 1)*A", 2.0, {{0, 1}});
}

TEST(MassAction, NothingElseIsTakenForIt) {
  for (const char* formula : {"k*A*A", "k*A^2", "k*(A - 1)", "k*A*(A - 2)", "k/A", "k*A + B", "k*A*(B - A)", "-k*A",
                              "k*A*t", "k*A/(1 + B)", "k*x", "k*A*(A + 1)", "k*A*(A < 5)"})
    EXPECT_FALSE(as_mass_action(formula, species, parameters)) << formula;
}

}  // namespace
}  // namespace shmoo::rdme
