// What leaps cost and what they must never do. The laws that they share with every method are in well_mixed.cpp and
// spatial.cpp.
#include "rdme/samplers/leap_condition.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr double k = 0.01, back = 1.0, total = 1e5;

scene::Scene dimers() {
  scene::Scene scene = water();
  const int m = add_species(scene, "M"), d = add_species(scene, "D");
  add_reaction(scene, "dimerisation", {{m, 2}}, {{d, 1}}, k);
  add_reaction(scene, "break-up", {{d, 1}}, {{m, 2}}, back);
  return scene;
}

// dM/dt = back (total - M) - 2 k M^2 = -2 k (M - high)(M - low), from M = total.
double monomers(double t) {
  const double root = std::sqrt(back * back + 8 * k * back * total);
  const double high = (root - back) / (4 * k), low = -(root + back) / (4 * k);
  const double z = (total - high) / (total - low) * std::exp(-2 * k * (high - low) * t);
  return (high - low * z) / (1 - z);
}

Sample copies(double tolerance, double until, int voxels) {
  Trial trial(scene::Sampler::tau_leaping, dimers(), lattice({std::uint32_t(voxels), 1, 1}, false, 1.0, 2));
  scene::Numerics numerics;
  numerics.sampler = scene::Sampler::tau_leaping;
  numerics.leap_tolerance = tolerance;
  trial.sampler = make_sampler(numerics, trial.network);
  trial.voxels.graph_of_species = {-1, -1};
  fill(trial.state, 0, std::int64_t(total));
  trial.begin();
  trial.run(until, until);
  return trial.sample(0);
}

// At 10^5 molecules means follow mass action to 1e-5.
TEST(TauLeaping, DimersAreRightToAThousandth) {
  for (const double t : {2e-3, 1e-2, 0.1}) {
    const Sample sample = copies(0.03, t, 50);
    const double wanted = monomers(t);
    EXPECT_NEAR(sample.mean(), wanted, 1e-3 * wanted + errors_allowed * sample.standard_error()) << "t = " << t;
  }
}

TEST(TauLeaping, ErrorIsOfSecondOrderInTheTolerance) {
  std::vector<double> errors;
  for (const double tolerance : {0.4, 0.2, 0.1}) {
    const Sample sample = copies(tolerance, 2e-3, 400);
    errors.push_back(std::abs(sample.mean() / monomers(2e-3) - 1));
  }
  EXPECT_GT(std::log2(errors[0] / errors[1]), 1.5);
  EXPECT_GT(std::log2(errors[1] / errors[2]), 1.5);
}

// Detailed balance: P(D) ~ K^D/(M! D!), of variance 4 M D/(M + 4 D) at these numbers.
TEST(TauLeaping, FluctuationsAreThoseOfEquilibrium) {
  const Sample sample = copies(0.03, 0.5, 2000);
  const double m = monomers(0.5), d = (total - m) / 2, variance = 4 * m * d / (m + 4 * d);
  EXPECT_NEAR(sample.variance(), variance, 0.01 * variance + errors_allowed * sample.variance_error());
}

// Everything is used up by three reactions at once, with leaps ten times as long as they should be.
TEST(TauLeaping, NothingEverBecomesNegative) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A"), b = add_species(scene, "B");
  add_reaction(scene, "decay", {{a, 1}}, {}, 1.0);
  add_reaction(scene, "pairing", {{a, 2}}, {{b, 1}}, 0.02);
  add_reaction(scene, "burst", {{a, 3}, {b, 1}}, {}, 1e-4);
  Trial trial(scene::Sampler::tau_leaping, scene, lattice({200, 1, 1}, false, 1.0, 2));
  scene::Numerics numerics;
  numerics.sampler = scene::Sampler::tau_leaping;
  numerics.leap_tolerance = 0.3;
  trial.sampler = make_sampler(numerics, trial.network);
  trial.voxels.graph_of_species = {-1, -1};
  fill(trial.state, a, 1000);
  trial.begin();
  for (int step = 0; step < 40; ++step) trial.run(trial.t + 0.5, 0.5);  // asserts counts >= 0 and the ledger
  EXPECT_EQ(total_count(trial.state, a), 0);
}

// The cases of section III of Cao, Gillespie & Petzold 2006, by hand: A + A, n = 101: g = 2 + 1/100.
TEST(TauLeaping, ConditionIsThatOfTheSource) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A");
  add_reaction(scene, "pairing", {{a, 2}}, {}, 1.0);
  const Network network(scene);
  State state = empty_state(network, 1);
  LeapCondition condition(network, 0.1);
  const std::vector<int> leaping{0};
  const std::vector<double> rate{50.0};
  state.count[0] = 101;
  const double allowed = 0.1 * 101 / (2 + 1.0 / 100);
  EXPECT_NEAR(condition.longest(leaping, rate, state, 0), std::min(allowed / 100, allowed * allowed / 200), 1e-12);
  state.count[0] = 19;
  EXPECT_TRUE(condition.critical(0, state, 0));
  state.count[0] = 20;
  EXPECT_FALSE(condition.critical(0, state, 0));
  EXPECT_NEAR(condition.longest(leaping, rate, state, 0), 1.0 / 200,
              1e-12);  // one molecule is the least that is allowed
}

}  // namespace
}  // namespace shmoo::rdme
