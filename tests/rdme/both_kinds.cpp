// Sampled reactions with deterministic partners, numbers at the edges of what can be, and what must be refused.
#include "base/error.hpp"
#include "rdme/deterministic.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr auto deterministic = scene::SpeciesMethod::deterministic;

class BothKinds : public testing::TestWithParam<scene::Sampler> {};

// D -> D + X: a deterministic catalyst of real amount makes Poisson numbers.
TEST_P(BothKinds, ADeterministicCatalystEntersAsARealAmount) {
  scene::Scene scene = water();
  const int d = add_species(scene, "D", 0, deterministic), x = add_species(scene, "X");
  add_reaction(scene, "birth", {{d, 1}}, {{d, 1}, {x, 1}}, 4.0);
  Trial trial(GetParam(), scene, lattice({2000, 1, 1}, false, 1.0, 2));
  trial.voxels.graph_of_species = {-1, -1};
  for (std::size_t i = 0; i < 2000; ++i) trial.state.amount[2 * i + d] = 0.75;
  trial.begin();
  trial.run(2.0, 2.0);
  EXPECT_GT(chi_square(trial.sample(x), poisson_law(6.0, 25)), false_alarm);
}

// D -> X takes whole molecules of D, at the rate n_D, until less than one is left.
TEST_P(BothKinds, AnEventTakesWholeMoleculesOfADeterministicAmount) {
  scene::Scene scene = water();
  const int d = add_species(scene, "D", 0, deterministic), x = add_species(scene, "X");
  add_reaction(scene, "conversion", {{d, 1}}, {{x, 1}}, 1.0);
  Trial trial(GetParam(), scene, lattice({1000, 1, 1}, false, 1.0, 2));
  trial.voxels.graph_of_species = {-1, -1};
  for (std::size_t i = 0; i < 1000; ++i) trial.state.amount[2 * i + d] = 10.5;
  trial.begin();
  // The mean while all amounts are far from the bound: the first event comes at 10.5, the second at 9.5.
  trial.run(0.02, 0.01);
  expect_mean(trial.sample(x), 10.5 * (1 - std::exp(-0.02)));
  trial.run(200.0, 100.0);
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(trial.state.amount[2 * i + d], 0.5);
    EXPECT_EQ(trial.state.count[2 * i + x], 10);
  }
  EXPECT_EQ(trial.state.ledger.amounts[d].destroyed, 10000.0);
  EXPECT_EQ(trial.state.ledger.counts[x].created, 10000);
}

// S + D <-> C with deterministic D, advanced in turns with its diffusion: first order in S, so means follow the linear
// law.
TEST_P(BothKinds, BindingFromADeterministicPool) {
  scene::Scene scene = water();
  const int s = add_species(scene, "S"), d = add_species(scene, "D", 1.0, deterministic), c = add_species(scene, "C");
  add_reaction(scene, "binding", {{s, 1}, {d, 1}}, {{c, 1}}, 1e-5);
  add_reaction(scene, "unbinding", {{c, 1}}, {{s, 1}, {d, 1}}, 1.0);
  Trial trial(GetParam(), scene, lattice({10, 1, 1}, false, 1.0, 3));
  trial.voxels.graph_of_species = {-1, 0, -1};
  for (std::size_t i = 0; i < 10; ++i) {
    trial.state.count[3 * i + s] = 100;
    trial.state.amount[3 * i + d] = 1e5;
  }
  trial.begin();
  DeterministicSolver solver(trial.network, 1e-6);
  solver.bind(trial.voxels, trial.state);
  Sample bound;
  for (int k = 0; k < 300; ++k) {
    for (int half = 0; half < 10; ++half) {
      solver.advance(trial.t, 0.1, Process::both);
      trial.sampler->amounts_changed();
      trial.run(trial.t + 0.1, 0.1);
    }
    if (k >= 5) bound.add(static_cast<double>(total_count(trial.state, c)) / 10);
  }
  EXPECT_NEAR(bound.mean(), 50.0, 6 * bound.standard_error() + 0.05);  // correlated samples; pool depleted by 0.05 %
  EXPECT_NEAR(total_amount(trial.state, d) + static_cast<double>(total_count(trial.state, c)), 1e6, 1e-6);
}

TEST_P(BothKinds, NothingAtAll) {
  Trial no_species(GetParam(), water(), lattice({3, 1, 1}, false, 1.0, 0));
  no_species.begin();
  no_species.run(1.0, 0.5);
  Trial no_voxels(GetParam(), water(), Voxels{});
  no_voxels.begin();
  no_voxels.run(1.0, 0.5);
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 0.0);
  add_reaction(scene, "never", {{a, 1}}, {}, 0.0);
  add_reaction(scene, "no change", {{a, 1}}, {{a, 1}}, 5.0);
  Trial zero_rates(GetParam(), scene, lattice({1, 1, 1}, false, 1.0, 1));
  fill(zero_rates.state, a, 7);
  zero_rates.begin();
  zero_rates.run(1e6, 5e5);
  EXPECT_EQ(zero_rates.state.count[0], 7);
  EXPECT_EQ(zero_rates.state.reaction_events + zero_rates.state.jump_events, 0U);
  scene.reactions[0].rate_constant = 1.0;
  Trial no_molecules(GetParam(), scene, lattice({2, 1, 1}, false, 1.0, 1));
  no_molecules.begin();
  no_molecules.run(1e6, 5e5);
  EXPECT_EQ(total_count(no_molecules.state, a), 0);
}

TEST_P(BothKinds, ABillionMolecules) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0);
  add_reaction(scene, "death", {{a, 1}}, {}, 1.0);
  Trial trial(GetParam(), scene, lattice({3, 1, 1}, false, 1.0, 1));
  trial.state.count[1] = 1000000000;
  trial.begin();
  trial.run(2e-4, 1e-4);
  const Account<std::int64_t>& account = trial.state.ledger.counts[a];
  EXPECT_NEAR(static_cast<double>(account.destroyed), 2e5, 5 * std::sqrt(2e5));
  EXPECT_NEAR(static_cast<double>(trial.state.count[0]), 2e5, 5 * std::sqrt(2e5) + 100);
}

TEST_P(BothKinds, RatesThatMakeNoSenseAreNamed) {
  for (const char* law : {"-1", "sqrt(A - 100)", "1/0*A"}) {
    scene::Scene scene = water();
    const int a = add_species(scene, "A");
    add_reaction(scene, "odd law", {{a, 1}}, {}, 0, law);
    Trial trial(GetParam(), scene, lattice({1, 1, 1}, false, 1.0, 1));
    fill(trial.state, a, 5);
    trial.begin();
    try {
      trial.sampler->advance(0, 1, Process::both, trial.key, 0);
      FAIL() << law;
    } catch (const base::RunError& error) {
      EXPECT_NE(std::string(error.what()).find("odd law"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("voxel 0"), std::string::npos);
    }
  }
}

// Short of a reactant nothing happens, whatever the expression says.
TEST_P(BothKinds, AnExpressionIsZeroWhereAReactantIsShort) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A");
  add_reaction(scene, "pair loss", {{a, 2}}, {}, 0, "1");
  Trial trial(GetParam(), scene, lattice({1, 1, 1}, false, 1.0, 1));
  fill(trial.state, a, 7);
  trial.begin();
  trial.run(1000.0, 500.0);
  EXPECT_EQ(trial.state.count[0], 1);
}

// Reactions alone leave positions alone, diffusion alone leaves totals alone.
TEST_P(BothKinds, AProcessActsAlone) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0);
  add_reaction(scene, "death", {{a, 1}}, {}, 1.0);
  Trial trial(GetParam(), scene, lattice({4, 1, 1}, false, 1.0, 1));
  trial.state.count[0] = 1000;
  trial.begin();
  trial.run(0.5, 0.5, Process::reactions);
  EXPECT_EQ(trial.state.jump_events, 0U);
  EXPECT_EQ(trial.state.count[1], 0);
  const std::int64_t left = trial.state.count[0];
  EXPECT_NEAR(static_cast<double>(left), 1000 * std::exp(-0.5), 4 * std::sqrt(1000 * 0.25));
  trial.run(1.5, 1.0, Process::diffusion);
  EXPECT_EQ(total_count(trial.state, a), left);
  EXPECT_GT(trial.state.count[1], 0);
}

INSTANTIATE_TEST_SUITE_P(Method, BothKinds, every_method, method_name);

}  // namespace
}  // namespace shmoo::rdme
