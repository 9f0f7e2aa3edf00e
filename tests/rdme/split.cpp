// Diffusion without events is exact for steps of any length; splitting reactions from it costs an error of second
// order.
#include <unsupported/Eigen/MatrixFunctions>

#include "rdme/jump_table.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr int n = 5;
using Matrix = Eigen::MatrixXd;

// A row of five voxels of unequal volumes and uneven rates; the mean number of jumps per unit time is about one.
Voxels uneven_row() {
  Voxels voxels = lattice({n, 1, 1}, false, 1.0, 1);
  voxels.volume = {1.0, 0.5, 2.0, 1.5, 0.8};
  const double strength[] = {0.6, 0.9, 0.3, 0.5};  // between i and i + 1
  JumpGraph& graph = voxels.graphs[0];
  for (int i = 0; i < n; ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      graph.coupling[p] = strength[std::min<std::uint32_t>(i, graph.target[p])] / voxels.volume[i];
    }
  }
  return voxels;
}

// dp/dt = p Q, p a row of expected numbers; exits leave it.
Matrix generator(const Voxels& voxels) {
  Matrix q = Matrix::Zero(n, n);
  const JumpGraph& graph = voxels.graphs[0];
  for (int i = 0; i < n; ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      q(i, graph.target[p]) += graph.coupling[p];
      q(i, i) -= graph.coupling[p];
    }
  }
  for (const Exchange& exchange : voxels.exchanges) q(exchange.voxel, exchange.voxel) -= exchange.exit_rate;
  return q;
}

// Expected numbers at t of what enters from time 0 on: entries times the integral of exp(Q s), from the exponential of
// an augmented matrix (Van Loan 1978).
Eigen::RowVectorXd entered_by(const Voxels& voxels, double t) {
  Matrix augmented = Matrix::Zero(n + 1, n + 1);
  augmented.bottomRightCorner(n, n) = generator(voxels);
  for (const Exchange& exchange : voxels.exchanges) augmented(0, 1 + exchange.voxel) += exchange.entry_rate;
  return (augmented * t).eval().exp().row(0).tail(n);
}

scene::Scene walkers() {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0);
  return scene;
}

// What starts is multinomial, what enters is Poisson, and both are independent. Errors are those that the law
// foretells, by its second and fourth cumulants: what is rare may not have been seen at all.
void expect_exact(Voxels voxels, double dt) {
  const Matrix law = (generator(voxels) * dt).eval().exp();
  const Eigen::RowVectorXd fed = entered_by(voxels, dt);
  const int start = 20;
  constexpr std::uint32_t trials = 4000;
  Trial trial(scene::Sampler::split, walkers(), std::move(voxels));
  std::vector<Sample> counts(n);
  for (std::uint32_t k = 0; k < trials; ++k) {
    trial.key.realisation = k;
    trial.state.count.assign(n, 0);
    trial.state.count[1] = start;
    trial.begin();
    trial.sampler->advance(0, dt, Process::diffusion, trial.key, 0);
    ASSERT_EQ(imbalance(trial.state, trial.network), "");
    for (int i = 0; i < n; ++i) counts[i].add(static_cast<double>(trial.state.count[i]));
  }
  for (int i = 0; i < n; ++i) {
    const double p = law(1, i);
    const double variance = start * p * (1 - p) + fed[i];
    const double fourth = start * p * (1 - p) * (1 - 6 * p * (1 - p)) + fed[i];
    EXPECT_NEAR(counts[i].mean(), start * p + fed[i], errors_allowed * std::sqrt(variance / trials));
    EXPECT_NEAR(counts[i].variance(), variance,
                errors_allowed * std::sqrt((fourth + 2 * variance * variance) / trials));
    for (int j = 0; j < i; ++j) {
      const double error = std::sqrt((counts[i].variance() + 1e-3) * (counts[j].variance() + 1e-3) / trials);
      EXPECT_NEAR(covariance(counts[i], counts[j]), -start * p * law(1, j), errors_allowed * error);
    }
  }
}

class AnyStep : public testing::TestWithParam<double> {};

TEST_P(AnyStep, DiffusionIsExact) { expect_exact(uneven_row(), GetParam()); }

TEST_P(AnyStep, DiffusionWithReservoirsIsExact) {
  Voxels voxels = uneven_row();
  voxels.exchanges = {{0, 0, 0.7, 3.0}, {2, 0, 0.0, 0.5}, {n - 1, 0, 0.4, 0.0}};
  expect_exact(voxels, GetParam());
}

TEST_P(AnyStep, ManyMoleculesAreMovedTogether) {
  Voxels voxels = uneven_row();
  const Matrix law = (generator(voxels) * GetParam()).eval().exp();
  Trial trial(scene::Sampler::split, walkers(), std::move(voxels));
  trial.state.count[1] = 1000000;
  trial.begin();
  trial.run(GetParam(), GetParam());
  std::vector<double> observed, expected;
  for (int i = 0; i < n; ++i) {
    observed.push_back(static_cast<double>(trial.state.count[i]));
    expected.push_back(1e6 * law(1, i));
  }
  EXPECT_GT(chi_square(observed, expected), false_alarm);
}

INSTANTIATE_TEST_SUITE_P(JumpsPerMolecule, AnyStep, testing::Values(0.1, 1.0, 10.0, 100.0));

// Steps in which hardly any molecule jumps, with few and with many molecules in a voxel: the number of jumps is
// Poisson.
TEST(Split, TinyStepsAreExact) {
  for (std::int64_t each : {50, 5000}) {
    Trial trial(scene::Sampler::split, walkers(), lattice({20, 20, 1}, true, 1.0, 1));
    fill(trial.state, 0, each);
    trial.begin();
    const double dt = 1e-4 / static_cast<double>(each) * 50;
    trial.run(100 * dt, dt);
    const double mean = 4.0 * 400 * static_cast<double>(each) * 100 * dt;
    EXPECT_NEAR(static_cast<double>(trial.state.jump_events), mean, errors_allowed * std::sqrt(mean));
  }
}

// Molecules vanish in the last voxel only, so reactions and diffusion do not commute. The expected numbers of Strang's
// scheme are products of exponentials; the sampler meets them, and they meet the exact law at second order.
TEST(Split, IsStrangsSchemeOfSecondOrder) {
  scene::Scene scene = walkers();
  scene.materials.resize(2);
  scene.species[0].homes = {0, 1};
  add_reaction(scene, "loss", {{0, 1}}, {}, 4.0);
  scene.reactions[0].materials = {1};
  const Matrix diffusion = generator(uneven_row());
  Matrix loss = Matrix::Zero(n, n);
  loss(n - 1, n - 1) = -4.0;
  const double total = 2.0;
  const Eigen::RowVectorXd exact = ((diffusion + loss) * total).eval().exp().row(3);
  std::vector<double> errors;
  for (int steps : {4, 8, 16}) {
    const double h = total / steps;
    const Matrix half = (loss * (h / 2)).eval().exp(), whole = (diffusion * h).eval().exp();
    Matrix law = Matrix::Identity(n, n);
    for (int k = 0; k < steps; ++k) law *= half * whole * half;
    errors.push_back((law.row(3) - exact).cwiseAbs().sum());

    Trial trial(scene::Sampler::split, scene, uneven_row());
    trial.voxels.material[n - 1] = 1;
    trial.state.count[3] = 400000;
    trial.begin();
    trial.run(total, h);
    for (int i = 0; i < n; ++i) {
      const double p = law(3, i);
      EXPECT_NEAR(static_cast<double>(trial.state.count[i]), 4e5 * p, errors_allowed * std::sqrt(4e5 * p * (1 - p)));
    }
  }
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.2);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.1);
}

// Species with equal rows share them, whatever their diffusivities; a flow gives each its own.
TEST(Split, SharesRowsBetweenSpecies) {
  scene::Scene scene = water();
  for (double kappa : {1.0, 3.0, 0.0}) add_species(scene, "S" + std::to_string(scene.species.size()), kappa);
  const Network network(scene);
  Voxels voxels = lattice({4, 1, 1}, true, 1.0, 3);
  const auto still = make_sampler(scene::Sampler::split, network)->prepare(voxels);
  EXPECT_EQ(still->of_species[0], still->of_species[1]);
  EXPECT_EQ(still->of_species[2], nullptr);
  voxels.graphs[0].flow.assign(8, 0.0);
  for (std::size_t i = 0; i < 4; ++i) voxels.graphs[0].flow[2 * i] = -(voxels.graphs[0].flow[2 * i + 1] = 1.0);
  const auto carried = make_sampler(scene::Sampler::split, network)->prepare(voxels);
  EXPECT_NE(carried->of_species[0], carried->of_species[1]);
  EXPECT_NE(carried->of_species[2], nullptr);
}

}  // namespace
}  // namespace shmoo::rdme
