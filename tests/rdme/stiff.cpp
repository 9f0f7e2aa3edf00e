// Rates over eight decades and more: accuracy against references, conservation, and no amount below zero.
#include <unsupported/Eigen/MatrixFunctions>

#include "continuum.hpp"

namespace shmoo::rdme {
namespace {

constexpr double accurate = 1e-6;  // relative error that is asked for

// Robertson's kinetics (1966): rate constants from 0.04 to 3e7.
scene::Scene robertson(double diffusivity) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", diffusivity, deterministic), b = add_species(scene, "B", 0, deterministic),
            c = add_species(scene, "C", diffusivity, deterministic);
  add_reaction(scene, "slow", {{a, 1}}, {{b, 1}}, 0.04);
  add_reaction(scene, "fast", {{b, 2}}, {{b, 1}, {c, 1}}, 3e7);
  add_reaction(scene, "back", {{b, 1}, {c, 1}}, {{a, 1}, {c, 1}}, 1e4);
  return scene;
}

struct Moment {
  double t, a, b, c;
};

// By Radau IIA of order 5 (Hairer & Wanner 1996) in steps of 2 % of the time; steps of 4 % give the same 11 digits.
constexpr Moment reference[] = {{0.4, 9.8517211386e-01, 3.38639537897e-05, 1.47940221852e-02},
                                {40.0, 7.1582706871936e-01, 9.1855347645594e-06, 2.8416374574587e-01},
                                {4e3, 1.8320225777662e-01, 8.9423712527709e-07, 8.1679684798625e-01},
                                {4e5, 4.9382745209776e-03, 1.9849940879535e-08, 9.9506170562908e-01}};

void follow_robertson(double diffusivity, std::uint32_t voxels) {
  Continuum run(robertson(diffusivity), lattice({voxels, 1, 1}, false, 1e12, 3), 1e-9);
  for (std::uint32_t i = 0; i < voxels; ++i) run.state.amount[3 * i] = 1e12;
  run.begin();
  for (const Moment& wanted : reference) {
    run.run(wanted.t, wanted.t);
    for (std::uint32_t i = 0; i < voxels; ++i) {
      const double* const n = &run.state.amount[3 * i];
      EXPECT_NEAR(n[0] * 1e-12, wanted.a, accurate * wanted.a) << "t = " << wanted.t;
      EXPECT_NEAR(n[1] * 1e-12, wanted.b, accurate * wanted.b) << "t = " << wanted.t;
      EXPECT_NEAR(n[2] * 1e-12, wanted.c, accurate * wanted.c) << "t = " << wanted.t;
    }
  }
}

TEST(Stiff, RobertsonInOneVoxel) { follow_robertson(0.0, 1); }
TEST(Stiff, RobertsonInManyVoxelsThatExchange) { follow_robertson(1e-3, 40); }

// A chain of conversions of 1e-4 to 1e4 /s between four species on three voxels that exchange.
TEST(Stiff, FirstOrderNetworkIsTheMatrixExponential) {
  constexpr int kinds = 4, places = 3;
  scene::Scene scene = water();
  for (int s = 0; s < kinds; ++s) add_species(scene, "S" + std::to_string(s), 0.1 * s, deterministic);
  const double forward[] = {1e4, 1.0, 1e-4}, backward[] = {3e3, 0.2, 5e-4};
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(kinds * places, kinds * places);  // dn/dt = n q
  const auto connect = [&](int from, int to, double rate) {
    q(from, to) += rate;
    q(from, from) -= rate;
  };
  for (int s = 0; s + 1 < kinds; ++s) {
    add_reaction(scene, "forward", {{s, 1}}, {{s + 1, 1}}, forward[s]);
    add_reaction(scene, "backward", {{s + 1, 1}}, {{s, 1}}, backward[s]);
    for (int i = 0; i < places; ++i) {
      connect(i * kinds + s, i * kinds + s + 1, forward[s]);
      connect(i * kinds + s + 1, i * kinds + s, backward[s]);
    }
  }
  for (int s = 0; s < kinds; ++s) {
    for (int i = 0; i + 1 < places; ++i) {
      connect(i * kinds + s, (i + 1) * kinds + s, 0.1 * s);
      connect((i + 1) * kinds + s, i * kinds + s, 0.1 * s);
    }
  }
  Continuum run(scene, lattice({places, 1, 1}, false, 1.0, kinds), 1e-9);
  run.state.amount[0] = 1e9;
  run.begin();
  for (const double t : {1e-4, 1e-1, 10.0, 1e4}) {
    run.run(t, t);
    const Eigen::VectorXd exact = 1e9 * (q * t).eval().exp().row(0);
    for (int at = 0; at < kinds * places; ++at)
      EXPECT_NEAR(run.state.amount[at], exact[at], accurate * exact[at] + 1e-3) << at << " at t = " << t;
  }
}

// A pulse spreads into emptiness while all is bound at once, at a coarse and at a fine tolerance. Rates per molecule
// differ by up to nine decades.
class Front : public testing::TestWithParam<std::pair<double, double>> {};

TEST_P(Front, NothingIsNegativeAndEveryLawHolds) {
  const auto [constant, tolerance] = GetParam();
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0, deterministic), b = add_species(scene, "B", 0.1, deterministic),
            c = add_species(scene, "C", 0.0, deterministic);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, constant);
  add_reaction(scene, "loss", {{c, 1}}, {}, 1e-3);
  Continuum run(scene, lattice({15, 15, 1}, false, 1.0, 3), tolerance);
  run.voxels.exchanges = {{7, 0, 50.0, 0.0}};
  run.state.amount[a] = 1e6;
  run.state.amount[3 * 224 + b] = 9e5;
  run.begin();
  double lowest = 0;
  for (int k = 0; k < 60; ++k) {
    run.run(0.02 * (k + 1) * (k + 1), 1.0);
    lowest = std::min(lowest, *std::ranges::min_element(run.state.amount));
  }
  EXPECT_GE(lowest, 0.0);
  const auto& ledger = run.state.ledger.amounts;
  EXPECT_GT(ledger[c].created, 1e5);
  EXPECT_NEAR(ledger[a].destroyed, ledger[c].created, 1e-8 * ledger[c].created);
  EXPECT_NEAR(ledger[b].destroyed, ledger[c].created, 1e-8 * ledger[c].created);
  EXPECT_EQ(imbalance(run.state, run.network, 1e-11), "");
}

INSTANTIATE_TEST_SUITE_P(ConstantAndTolerance, Front,
                         testing::Values(std::pair{1.0, 1e-3}, std::pair{1.0, 1e-6}, std::pair{1e2, 1e-3},
                                         std::pair{1e2, 1e-6}, std::pair{1e2, 1e-8}, std::pair{1e5, 1e-6}));

}  // namespace
}  // namespace shmoo::rdme
