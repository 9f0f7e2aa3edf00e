// Deterministic reaction-diffusion: exact solutions, conservation to round-off, and reactions between both kinds of
// species.
#include <numbers>

#include "base/error.hpp"
#include "continuum.hpp"

namespace shmoo::rdme {
namespace {

TEST(Deterministic, DiffusionOnARowIsExact) {
  const int n = 9, from = 3;
  scene::Scene scene = water();
  add_species(scene, "A", 0.5, deterministic);
  Continuum run(scene, lattice({n, 1, 1}, false, 2.0, 1), 1e-8);
  run.state.amount[from] = 1e4;
  run.begin();
  run.run(3.0, 0.7);
  for (int i = 0; i < n; ++i) {
    double p = 1.0 / n;
    for (int k = 1; k < n; ++k) {
      const double angle = std::numbers::pi * k / n;
      p += 2.0 / n * std::cos(angle * (i + 0.5)) * std::cos(angle * (from + 0.5)) *
           std::exp(-4 * 0.5 * std::pow(std::sin(angle / 2), 2) * 3.0);
    }
    EXPECT_NEAR(run.state.amount[i], 1e4 * p, 1e-2);
    EXPECT_GT(run.state.amount[i], 0.0);
  }
  EXPECT_NEAR(total_amount(run.state, 0), 1e4, 1e-8);
}

TEST(Deterministic, PairsVanishAtTwiceTheRateConstant) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 0, deterministic);
  const int b = add_species(scene, "B", 0, deterministic);
  add_reaction(scene, "dimerisation", {{a, 2}}, {{b, 1}}, 0.3);
  Continuum run(scene, lattice({1, 1, 1}, false, 5.0, 2));
  run.state.amount = {1000.0, 0.0};
  run.begin();
  run.run(0.1, 0.1);
  const double exact = 1000.0 / (1 + 2 * 0.3 * 1000.0 / 5.0 * 0.1);
  EXPECT_NEAR(run.state.amount[a], exact, 1e-4 * exact);
  EXPECT_NEAR(run.state.amount[a] + 2 * run.state.amount[b], 1000.0, 1e-9);
}

TEST(Deterministic, ConservesToRoundOffAtAnyTolerance) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0, deterministic), b = add_species(scene, "B", 3.0, deterministic),
            c = add_species(scene, "C", 0.2, deterministic);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 2.0);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 5.0);
  Continuum run(scene, lattice({6, 5, 1}, false, 1.0, 3), 1e-2);
  for (std::size_t i = 0; i < 15; ++i) run.state.amount[3 * i + a] = 100.0 + static_cast<double>(i);
  for (std::size_t i = 10; i < 30; ++i) run.state.amount[3 * i + b] = 50.0;
  run.begin();
  const double ac = total_amount(run.state, a), bc = total_amount(run.state, b);
  run.run(2.0, 0.05);
  EXPECT_NEAR(total_amount(run.state, a) + total_amount(run.state, c), ac, 1e-11 * ac);
  EXPECT_NEAR(total_amount(run.state, b) + total_amount(run.state, c), bc, 1e-11 * bc);
  EXPECT_EQ(imbalance(run.state, run.network, 1e-11), "");
  EXPECT_GT(run.state.ledger.amounts[c].created, 0.0);
}

TEST(Deterministic, ExchangesWithReservoirs) {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0, deterministic);
  const std::uint32_t n = 10;
  Continuum run(scene, lattice({n, 1, 1}, false, 1.0, 1));
  run.voxels.exchanges = {{0, 0, 2.0, 2.0 * 100.0}, {n - 1, 0, 2.0, 0.0}};
  run.begin();
  run.run(300.0, 50.0);
  for (std::uint32_t i = 0; i < n; ++i) EXPECT_NEAR(run.state.amount[i], 100.0 * (n - i - 0.5) / n, 1e-3);
  EXPECT_GT(run.state.ledger.amounts[0].left, 0.0);
}

// An expression and its mass action agree; Michaelis-Menten with a stochastic enzyme reads the frozen count.
TEST(Deterministic, ExpressionsAndStochasticReactants) {
  scene::Scene scene = water();
  scene.parameters["km"] = 3.0;
  const int s = add_species(scene, "S", 0, deterministic), p = add_species(scene, "P", 0, deterministic);
  const int e = add_species(scene, "E"), x = add_species(scene, "X", 0, deterministic);
  add_reaction(scene, "turnover", {{s, 1}}, {{p, 1}}, 0, "2*E*S/(km + S)");
  add_reaction(scene, "loss", {{x, 1}, {e, 2}}, {{e, 2}}, 0.1);
  Continuum run(scene, lattice({1, 1, 1}, false, 2.0, 4), 1e-8);
  run.state.amount = {40.0, 0.0, 0.0, 80.0};
  run.state.count[e] = 4;
  run.begin();
  run.run(1.0, 0.25);
  // km ln(S0/S) + S0 - S = 2 E t in concentrations; X falls at 0.1 V^-2 * 4 * 3.
  const double left = run.state.amount[s] / 2.0;
  EXPECT_NEAR(3.0 * std::log(20.0 / left) + 20.0 - left, 2 * 2.0 * 1.0, 1e-5);
  EXPECT_NEAR(run.state.amount[x], 80.0 * std::exp(-0.1 / 4 * 12 * 1.0), 1e-5);
}

TEST(Deterministic, GoesOnWhereNothingChanged) {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0, deterministic);
  Continuum one(scene, lattice({30, 1, 1}, false, 1.0, 1)), two(scene, lattice({30, 1, 1}, false, 1.0, 1));
  one.state.amount[3] = two.state.amount[3] = 1000.0;
  one.begin();
  two.begin();
  for (int k = 0; k < 50; ++k) {
    one.run(0.1 * (k + 1), 0.1);
    two.solver.bind(two.voxels, two.state);
    two.run(0.1 * (k + 1), 0.1);
  }
  EXPECT_LT(3 * one.solver.evaluations(), two.solver.evaluations());
  for (std::size_t i = 0; i < 30; ++i) EXPECT_NEAR(one.state.amount[i], two.state.amount[i], 1e-2);
}

TEST(Deterministic, RefusesWhatHasNoSense) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 0, deterministic);
  scene::Scene negative = scene, undefined = scene, explosive = scene;
  add_reaction(negative, "wrong sign", {{a, 1}}, {}, 0, "A - 10");
  add_reaction(undefined, "root", {{a, 1}}, {}, 0, "sqrt(A - 10)");
  add_reaction(explosive, "explosion", {{a, 2}}, {{a, 3}}, 1.0);
  for (const scene::Scene& bad : {negative, undefined, explosive}) {
    Continuum run(bad, lattice({1, 1, 1}, false, 1.0, 1));
    run.state.amount[0] = 1.0;
    run.begin();
    EXPECT_THROW(run.solver.advance(0.0, 5.0, Process::both), base::RunError);
  }
  EXPECT_THROW(DeterministicSolver(Network(scene), 0.0), base::InputError);
}

TEST(Deterministic, NoSpeciesNoVoxelsNothingThere) {
  Continuum nothing(water(), Voxels{});
  nothing.begin();
  nothing.run(1.0, 0.5);
  scene::Scene scene = water();
  add_species(scene, "A", 1.0, deterministic);
  Continuum empty(scene, lattice({3, 1, 1}, false, 1.0, 1));
  empty.begin();
  empty.run(1.0, 0.5);
  EXPECT_EQ(total_amount(empty.state, 0), 0.0);
}

}  // namespace
}  // namespace shmoo::rdme
