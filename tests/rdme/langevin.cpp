// Chemical Langevin dynamics: means and variances of known laws where voxels hold hundreds of molecules, conservation,
// and no amount below zero where they hold few.
#include "rdme/langevin.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr auto langevin = scene::SpeciesMethod::langevin;

struct Noisy {
  Network network;
  Voxels voxels;
  State state;
  LangevinSolver solver;
  base::RandomKey key{1, 0};
  double t = 0;
  std::uint64_t step = 0;

  Noisy(const scene::Scene& scene, Voxels on)
      : network(scene), voxels(std::move(on)), state(empty_state(network, voxels.size())), solver(network) {}
  Noisy(const Noisy&) = delete;

  void begin() {
    open_ledger(state, network);
    solver.bind(voxels, state);
  }
  void run(double until, double dt, Process process = Process::both) {
    while (t < until * (1 - 1e-12)) {
      const double now = std::min(dt, until - t);
      solver.advance(t, now, process, key, step++);
      t += now;
    }
    EXPECT_EQ(imbalance(state, network), "");
    for (const double n : state.amount) ASSERT_GE(n, 0.0);
  }
  Sample sample(int species) const {
    Sample sample;
    for (std::size_t i = species; i < state.amount.size(); i += state.species) sample.add(state.amount[i]);
    return sample;
  }
  void fill(int species, double amount) {
    for (std::size_t i = species; i < state.amount.size(); i += state.species) state.amount[i] = amount;
  }
};

Voxels copies(std::uint32_t number, std::size_t species) {
  Voxels voxels = lattice({number, 1, 1}, false, 1.0, species);
  voxels.graph_of_species.assign(species, -1);
  return voxels;
}

// From 150 molecules: those that are left are binomial, those that came are Poisson.
TEST(Langevin, BirthAndDeath) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X", 0, langevin);
  add_reaction(scene, "birth", {}, {{x, 1}}, 400.0);
  add_reaction(scene, "death", {{x, 1}}, {}, 1.0);
  Noisy run(scene, copies(8000, 1));
  run.fill(x, 150);
  run.begin();
  run.run(1.0, 0.5);
  const double left = std::exp(-1.0);
  expect_mean(run.sample(x), 150 * left + 400 * (1 - left));
  expect_variance(run.sample(x), 150 * left * (1 - left) + 400 * (1 - left));
  run.run(8.0, 7.0);
  expect_mean(run.sample(x), 400);
  expect_variance(run.sample(x), 400);
}

// 2 M <-> D: P(D) ~ K^D/(M! D!), of mean as by mass action and variance 4 M D/(M + 4 D) up to parts in M.
TEST(Langevin, DimersInEquilibrium) {
  scene::Scene scene = water();
  const int m = add_species(scene, "M", 0, langevin), d = add_species(scene, "D", 0, langevin);
  add_reaction(scene, "dimerisation", {{m, 2}}, {{d, 1}}, 0.001);
  add_reaction(scene, "break-up", {{d, 1}}, {{m, 2}}, 1.0);
  Noisy run(scene, copies(4000, 2));
  run.fill(m, 1000);
  run.fill(d, 500);
  run.begin();
  run.run(4.0, 4.0);
  double weight = 0, first = 0, second = 0;  // the exact law
  for (int n = 0; n <= 1000; ++n) {
    const double M = 2000 - 2 * n;
    const double p = std::exp(n * std::log(0.001) - std::lgamma(M + 1) - std::lgamma(n + 1.0) + 12000);
    weight += p;
    first += p * M;
    second += p * M * M;
  }
  const double mean = first / weight;
  expect_mean(run.sample(m), mean);
  expect_variance(run.sample(m), second / weight - mean * mean);
}

// A closed row of unequal voxels from one full voxel; numbers are multinomial at all times.
TEST(Langevin, DiffusionHasTheVarianceOfTheMultinomial) {
  constexpr int n = 6, realisations = 3000;
  constexpr double total = 6000;
  scene::Scene scene = water();
  add_species(scene, "A", 1.0, langevin);
  std::vector<Sample> counts(n);
  Noisy run(scene, lattice({n, 1, 1}, false, 1.0, 1));
  for (std::uint32_t k = 0; k < realisations; ++k) {
    run.key.realisation = k;
    run.fill(0, total / n);
    run.t = 0;
    run.begin();
    run.run(30.0, 10.0);
    double sum = 0;
    for (int i = 0; i < n; ++i) {
      counts[i].add(run.state.amount[i]);
      sum += run.state.amount[i];
    }
    ASSERT_NEAR(sum, total, 1e-9 * total);
  }
  for (int i = 0; i < n; ++i) {
    expect_mean(counts[i], total / n);
    expect_variance(counts[i], total / n * (1 - 1.0 / n));
  }
  const double error = total / n / std::sqrt(double(realisations));
  EXPECT_NEAR(covariance(counts[0], counts[4]), -total / n / n, errors_allowed * error);
}

// Between reservoirs numbers are Poisson in every voxel.
TEST(Langevin, ReservoirsGivePoissonNumbers) {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0, langevin);
  Noisy run(scene, lattice({3, 1, 1}, false, 1.0, 1));
  run.voxels.exchanges = {{0, 0, 2.0, 800.0}, {2, 0, 2.0, 400.0}};
  run.fill(0, 300);
  run.begin();
  run.run(20.0, 20.0);
  std::vector<Sample> counts(3);
  for (int k = 0; k < 1500; ++k) {
    run.run(run.t + 6.0, 6.0);
    for (int i = 0; i < 3; ++i) counts[i].add(run.state.amount[i]);
  }
  for (int i = 0; i < 3; ++i) {
    const double mean = 400 - 200 * (i + 0.5) / 3;
    expect_mean(counts[i], mean);
    expect_variance(counts[i], mean);
  }
  EXPECT_GT(run.state.ledger.amounts[0].left, 1e6);
}

// One molecule a voxel and less: no law is met, but nothing is negative and everything is conserved.
TEST(Langevin, FewMoleculesStayAboveZero) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0, langevin), b = add_species(scene, "B", 0.3, langevin),
            c = add_species(scene, "C", 0.0, langevin);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 3.0);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 1.0);
  Noisy run(scene, lattice({8, 8, 1}, true, 1.0, 3));
  run.fill(a, 1.0);
  run.fill(b, 0.4);
  run.begin();
  run.run(20.0, 0.5);
  EXPECT_NEAR(total_amount(run.state, a) + total_amount(run.state, c), 64.0, 1e-9);
  EXPECT_NEAR(total_amount(run.state, b) + total_amount(run.state, c), 0.4 * 64, 1e-9);
}

TEST(Langevin, IsAFunctionOfItsAddress) {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0, langevin);
  std::vector<std::vector<double>> ends;
  for (const std::uint64_t step : {5U, 5U, 6U}) {
    Noisy run(scene, lattice({600, 1, 1}, true, 1.0, 1));
    run.fill(0, 100.0);
    run.step = step;
    run.begin();
    run.run(0.1, 0.1);
    ends.push_back(run.state.amount);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_NE(ends[0], ends[2]);
}

}  // namespace
}  // namespace shmoo::rdme
