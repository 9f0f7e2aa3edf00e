// Jumps, reservoirs and reactions in space, every method against exact laws.
#include <gsl/gsl_sf_gamma.h>

#include <numbers>

#include "trial.hpp"

namespace shmoo::rdme {
namespace {

class Spatial : public testing::TestWithParam<scene::Sampler> {
 protected:
  // The step that keeps the splitting error below what these tests see; exact methods take what they like.
  double step(double exact, double split) const { return takes_turns(GetParam()) ? split : exact; }
};

scene::Scene walkers() {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0);
  return scene;
}

TEST_P(Spatial, EquilibriumHasEqualConcentrationsInUnequalVolumes) {
  Trial trial(GetParam(), walkers(), lattice({10, 1, 1}, false, 1.0, 1));
  JumpGraph& graph = trial.voxels.graphs[0];
  for (std::size_t i = 0; i < 10; ++i) {
    trial.voxels.volume[i] = i % 2 == 0 ? 8.0 : 1.0;
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p)
      graph.coupling[p] = 1.0 / trial.voxels.volume[i];
  }
  fill(trial.state, 0, 45);
  trial.begin();
  trial.run(400.0, 100.0);
  Sample large, small;
  for (int k = 0; k < 400; ++k) {
    trial.run(trial.t + 40.0, 40.0);
    large.add(static_cast<double>(trial.state.count[2]));
    small.add(static_cast<double>(trial.state.count[5]));
  }
  expect_mean(large, 80.0);
  expect_mean(small, 10.0);
  EXPECT_NEAR(large.mean() / 8, small.mean(), 3 * std::hypot(large.standard_error() / 8, small.standard_error()));
  expect_variance(large, 450 * (8.0 / 45) * (37.0 / 45));
  expect_variance(small, 450 * (1.0 / 45) * (44.0 / 45));
}

// Reflecting row of n voxels, jump rate 1: p_i(t) = 1/n + (2/n) sum_k cos(..i) cos(..j) exp(-4 sin^2(pi k/(2n)) t).
std::vector<double> row_law(int n, int from, double t) {
  std::vector<double> p(n, 1.0 / n);
  for (int i = 0; i < n; ++i) {
    for (int k = 1; k < n; ++k) {
      const double angle = std::numbers::pi * k / n;
      p[i] += 2.0 / n * std::cos(angle * (i + 0.5)) * std::cos(angle * (from + 0.5)) *
              std::exp(-4 * std::pow(std::sin(angle / 2), 2) * t);
    }
  }
  return p;
}

TEST_P(Spatial, TransientOnARowIsMultinomial) {
  const auto p = row_law(7, 2, 1.3);
  Trial many(GetParam(), walkers(), lattice({7, 1, 1}, false, 1.0, 1));
  many.state.count[2] = 20000;
  many.begin();
  many.run(1.3, 0.65);
  std::vector<double> observed, expected;
  for (int i = 0; i < 7; ++i) {
    observed.push_back(static_cast<double>(many.state.count[i]));
    expected.push_back(20000 * p[i]);
  }
  EXPECT_GT(chi_square(observed, expected), false_alarm);

  std::vector<Sample> counts(7);
  Trial few(GetParam(), walkers(), lattice({7, 1, 1}, false, 1.0, 1));
  for (int k = 0; k < 2000; ++k) {
    few.key.realisation = k;
    few.state.count.assign(7, 0);
    few.state.count[2] = 12;
    few.t = 0;
    few.begin();
    few.run(1.3, 1.3);
    for (int i = 0; i < 7; ++i) counts[i].add(static_cast<double>(few.state.count[i]));
  }
  for (int i = 0; i < 7; ++i) {
    expect_mean(counts[i], 12 * p[i]);
    for (int j = 0; j < i; ++j) {
      const double error = std::sqrt(counts[i].variance() * counts[j].variance() / 2000);
      EXPECT_NEAR(covariance(counts[i], counts[j]), -12 * p[i] * p[j], errors_allowed * error);
    }
  }
}

// Absorbed at rate 1 from the last of 20 voxels, reflected at the first: n (n + 1)/2 = 210 on average.
TEST_P(Spatial, FirstPassageTime) {
  Trial trial(GetParam(), walkers(), lattice({20, 1, 1}, false, 1.0, 1));
  trial.voxels.exchanges = {{19, 0, 1.0, 0.0}};
  trial.state.count[0] = 2000;
  trial.begin();
  double time = 0, squares = 0;
  std::int64_t before = 0;
  while (trial.t < 2000) {
    trial.run(trial.t + 4.0, 4.0);
    const std::int64_t gone = trial.state.ledger.counts[0].left;
    time += static_cast<double>(gone - before) * (trial.t - 2.0);
    squares += static_cast<double>(gone - before) * (trial.t - 2.0) * (trial.t - 2.0);
    before = gone;
  }
  ASSERT_EQ(before, 2000);
  const double mean = time / 2000, error = std::sqrt((squares / 2000 - mean * mean) / 2000);
  EXPECT_NEAR(mean, 210.0, errors_allowed * error);
}

// A slab between a reservoir (voxel 0) and an absorbing side: linear profile, Poisson numbers. Chains side by side are
// copies.
TEST_P(Spatial, SlabFedByAReservoir) {
  const std::uint32_t n = 4, copies = 150;
  Voxels voxels = lattice({n, 1, 1}, false, 1.0, 1);
  JumpGraph one = voxels.graphs[0];
  for (std::uint32_t copy = 1; copy < copies; ++copy) {
    JumpGraph& graph = voxels.graphs[0];
    for (std::uint32_t i = 0; i < n; ++i) {
      voxels.volume.push_back(1.0);
      voxels.material.push_back(0);
      voxels.position.push_back(voxels.position[i]);
      graph.first.push_back(graph.first[copy * n] + one.first[i + 1]);
    }
    for (std::uint32_t target : one.target) graph.target.push_back(target + copy * n);
    graph.coupling.insert(graph.coupling.end(), one.coupling.begin(), one.coupling.end());
  }
  for (std::uint32_t copy = 0; copy < copies; ++copy) {
    voxels.exchanges.push_back({copy * n, 0, 2.0, 2.0 * 9.0});  // half a spacing from a side at 9 molecules a voxel
    voxels.exchanges.push_back({copy * n + n - 1, 0, 2.0, 0.0});
  }
  Trial trial(GetParam(), walkers(), voxels);
  trial.begin();
  trial.run(15.0, step(15.0, 5.0));
  for (std::uint32_t i = 0; i < n; ++i) {
    Sample sample;
    for (std::uint32_t copy = 0; copy < copies; ++copy)
      sample.add(static_cast<double>(trial.state.count[copy * n + i]));
    const double mean = 9.0 * (n - i - 0.5) / n;
    expect_mean(sample, mean);
    expect_variance(sample, mean);
    EXPECT_GT(chi_square(sample, poisson_law(mean, 25)), false_alarm);
  }
  EXPECT_GT(trial.state.ledger.counts[0].entered, 0);
  EXPECT_GT(trial.state.ledger.counts[0].left, 0);
}

// A + B <-> C with diffusion, voxels of unequal volume. The total of C has the law of one well mixed volume; given the
// totals, molecules are spread multinomially (product Poisson conditioned on the conserved totals).
TEST_P(Spatial, BindingIsProductPoissonGivenTotals) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 2.0), b = add_species(scene, "B", 3.0), c = add_species(scene, "C", 1.0);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 6.0);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 1.0);
  Trial trial(GetParam(), scene, lattice({2, 2, 1}, false, 1.0, 3));
  trial.voxels.volume = {1, 1, 2, 2};
  JumpGraph& graph = trial.voxels.graphs[0];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p)
      graph.coupling[p] = 1.0 / trial.voxels.volume[i];
  }
  trial.state.count[a] = 5;
  trial.state.count[b] = 5;
  trial.begin();
  Sample total, first;
  for (int k = 0; k < 3000; ++k) {
    trial.run(trial.t + 3.0, step(3.0, 0.03));
    total.add(static_cast<double>(total_count(trial.state, c)));
    first.add(static_cast<double>(trial.state.count[c]));
  }
  std::vector<double> law(6);  // c_f = 6/6 = 1, c_r = 1
  double sum = 0;
  for (int k = 0; k <= 5; ++k) sum += law[k] = 1.0 / (gsl_sf_fact(k) * std::pow(gsl_sf_fact(5 - k), 2));
  for (double& p : law) p /= sum;
  const auto table = read_table("abc_reversible_stationary.csv");
  const double mean = table.at("mean_C")[1], variance = table.at("var_C")[1];
  EXPECT_GT(chi_square(total, law), false_alarm);
  expect_mean(total, mean);
  expect_variance(total, variance);
  expect_mean(first, mean / 6);
  expect_variance(first, mean * (1.0 / 6) * (5.0 / 6) + variance / 36);
}

// Birth, death and jumps on a cube: independent Poisson numbers, whatever the rates of jumping.
TEST_P(Spatial, BirthAndDeathWithJumpsStaysPoisson) {
  scene::Scene scene = walkers();
  add_reaction(scene, "birth", {}, {{0, 1}}, 12.0);
  add_reaction(scene, "death", {{0, 1}}, {}, 2.0);
  Trial trial(GetParam(), scene, lattice({8, 8, 8}, true, 1.0, 1));
  fill(trial.state, 0, 6);
  trial.begin();
  Sample all, total;
  for (int k = 0; k < 12; ++k) {
    trial.run(trial.t + 1.5, step(1.5, 0.05));
    for (double n : trial.sample(0).values) all.add(n);
    total.add(static_cast<double>(total_count(trial.state, 0)));
  }
  EXPECT_GT(chi_square(all, poisson_law(6.0, 25)), false_alarm);
  EXPECT_NEAR(total.mean(), 6.0 * 512, errors_allowed * std::sqrt(6.0 * 512 / 12));
}

// A flow that carries molecules round a ring: the mean position moves with q/V per unit time.
TEST_P(Spatial, AFlowCarriesMolecules) {
  Trial trial(GetParam(), walkers(), lattice({40, 1, 1}, true, 2.0, 1));
  JumpGraph& graph = trial.voxels.graphs[0];
  for (std::uint32_t i = 0; i < 40; ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      graph.flow.push_back(graph.target[p] == (i + 1) % 40 ? 3.0 : -3.0);
    }
  }
  trial.state.count[10] = 5000;
  trial.begin();
  trial.run(4.0, 2.0);
  double mean = 0;
  for (int i = 0; i < 40; ++i) mean += (i - 10) * static_cast<double>(trial.state.count[i]) / 5000;
  // Jumps of +1 at 1 + 0.75 and of -1 at 1 - 0.75 per unit time.
  EXPECT_NEAR(mean, 1.5 * 4.0, errors_allowed * std::sqrt(2.0 * 4.0 / 5000));
}

TEST_P(Spatial, SameKeySameBitsAndOtherRealisationsDiffer) {
  std::vector<std::vector<std::int64_t>> counts;
  for (std::uint32_t realisation : {3U, 3U, 4U}) {
    scene::Scene scene = walkers();
    add_reaction(scene, "pair loss", {{0, 2}}, {{0, 1}}, 0.1);
    Trial trial(GetParam(), scene, lattice({4, 4, 1}, true, 1.0, 1));
    fill(trial.state, 0, 20);
    trial.key = {77, realisation};
    trial.begin();
    trial.run(1.0, 0.25);
    counts.push_back(trial.state.count);
  }
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_NE(counts[0], counts[2]);
}

INSTANTIATE_TEST_SUITE_P(Method, Spatial, every_method, method_name);

}  // namespace
}  // namespace shmoo::rdme
