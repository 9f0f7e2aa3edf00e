// The shipped yeast projection, coarse and short, and what it owes to physics; and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

using scene::Overrides;

// Three layers and 40 columns; 200 s.
scene::Scene coarse(const Overrides& more = {}) {
  Overrides all{{"domain.spacing", "\"0.8 um\""},
                {"mechanics.columns", "40"},
                {"mechanics.step", "\"10 s\""},
                {"run.until", "\"200 s\""},
                {"run.record_every", "\"50 s\""}};
  all.insert(all.end(), more.begin(), more.end());
  return scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/yeast-projection/case-1.toml", all);
}

double last(const Laboratory& laboratory, const std::string& observable) {
  return laboratory.shared.observed(observable, laboratory.experiment->layout().times.size() - 1)[0];
}

double extension(const Overrides& more) { return last(Laboratory(coarse(more)), "projection_length"); }

std::string refusal(const Overrides& more) {
  try {
    Laboratory laboratory(coarse(more));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(QuasiStatic, AProjectionGrowsAndEveryMoleculeIsAccountedFor) {
  Laboratory laboratory(coarse());
  double length = -1.0;
  for (std::size_t t = 0; t < laboratory.experiment->layout().times.size(); ++t) {
    EXPECT_GT(laboratory.shared.observed("projection_length", t)[0], length);
    length = laboratory.shared.observed("projection_length", t)[0];
    for (const double amount : laboratory.shared.at("E", t)) EXPECT_GE(amount, 0.0);
  }
  EXPECT_GT(length, 0.4e-6);
  EXPECT_LE(last(laboratory, "residual"), 1e-8);
  EXPECT_EQ(last(laboratory, "outside"), 0.0);
  Outcome outcome;
  laboratory.realise(0, &outcome);
  const auto& account = outcome.ledger.amounts[0];
  EXPECT_NEAR(last(laboratory, "enzyme"), account.expected(), 1e-12 * account.entered);
}

TEST(QuasiStatic, MoleculesAreWholeAndRepeatable) {
  const Overrides brief{{"run.until", "\"40 s\""}, {"run.record_every", "\"20 s\""}};
  Overrides few{{"species.E.method", "\"stochastic\""}, {"numerics.sampler", "\"split\""}};
  few.insert(few.end(), brief.begin(), brief.end());
  Laboratory laboratory(coarse(few)), again(coarse(few));
  Outcome outcome;
  const auto first = laboratory.realise(1, &outcome), second = again.realise(1);
  EXPECT_TRUE(outcome.balanced);
  const std::size_t end = laboratory.experiment->layout().times.size() - 1;
  EXPECT_EQ(first.at("E", end), second.at("E", end));
  EXPECT_EQ(first.at("position", end), second.at("position", end));
  EXPECT_NE(first.observed("projection_length", end), laboratory.realise(2).observed("projection_length", end));
  EXPECT_NEAR(first.observed("projection_length", end)[0], extension(brief), 0.02e-6);
}

TEST(QuasiStatic, TheSameBitsFromTheSameScene) { EXPECT_EQ(extension({}), extension({})); }

// Softening makes no projection: without growth the tip bulges by less than a tenth of a micrometre.
TEST(QuasiStatic, WithoutGrowthThereIsNoProjection) {
  EXPECT_LT(std::abs(extension({{"materials.wall.growth.coefficient", "\"1e-9 m^3/(mol MPa s)\""}})), 0.1e-6);
}

// Without species nothing happens: the inflated shape stays to 1e-8 um.
TEST(QuasiStatic, WithoutEnzymeTheCellKeepsItsShape) {
  EXPECT_LT(std::abs(extension({{"mechanics.source.0.concentration", "\"1e-9 mol/m^3\""}})), 1e-13);
}

TEST(QuasiStatic, HalvingTheStepChangesLittle) {
  const double full = extension({}), half = extension({{"mechanics.step", "\"5 s\""}});
  EXPECT_NEAR(full, half, 0.05 * half);
}

TEST(QuasiStatic, RefusesWhatItCannotCompute) {
  EXPECT_NE(refusal({{"mechanics.turgor", "\"0.3 MPa\""}}).find("limit load"), std::string::npos);
  EXPECT_NE(refusal({{"domain.spacing", "\"2 um\""}}).find("spacings thick"), std::string::npos);
  EXPECT_NE(refusal({{"region.0.center", "[\"0 um\", \"3 um\"]"}}).find("x axis"), std::string::npos);
  EXPECT_NE(refusal({{"species.E.in", "\"cytoplasm\""}}), "");
  EXPECT_NE(refusal({{"mechanics.motion", "\"dynamic\""}}), "");
}

}  // namespace
}  // namespace shmoo::coupling
