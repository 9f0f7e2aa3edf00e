// RD-10 at rest: A + B <-> C with diffusion on 10^3 voxels. The stationary law is product Poisson with mean 10,
// conditioned on the two conserved totals A + C and B + C. Means within 3 standard errors; joint law of a voxel by
// chi-square on samples that are thinned by the measured autocorrelation time.
#include <fmt/core.h>

#include "../trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr int voxels = 1000, mean = 10, largest = 40;

double log_poisson(double n, double lambda) { return n * std::log(lambda) - lambda - std::lgamma(n + 1); }

// Probability that M voxels of independent Poisson numbers have A + C = ac and B + C = bc.
double log_totals(int m, int ac, int bc) {
  const double lambda = static_cast<double>(m) * mean;
  const int centre = std::min({ac, bc, static_cast<int>(lambda)});
  double sum = 0, top = -1e300;
  std::vector<double> terms;
  for (int c = std::max(0, centre - 2000); c <= std::min({ac, bc, centre + 2000}); ++c) {
    terms.push_back(log_poisson(c, lambda) + log_poisson(ac - c, lambda) + log_poisson(bc - c, lambda));
    top = std::max(top, terms.back());
  }
  for (double term : terms) sum += std::exp(term - top);
  return top + std::log(sum);
}

// Sum of the autocorrelation of a series until it drowns in noise, in steps.
double correlation_time(const std::vector<Sample>& series) {
  double time = 0.5;
  for (std::size_t lag = 1; lag < 60; ++lag) {
    double sum = 0;
    for (const Sample& one : series) {
      double product = 0;
      for (std::size_t i = 0; i + lag < one.values.size(); ++i) {
        product += (one.values[i] - mean) * (one.values[i + lag] - mean);
      }
      sum += product / (one.n - static_cast<double>(lag)) / mean / static_cast<double>(series.size());
    }
    if (sum < 0.01) break;
    time += sum;
  }
  return time;
}

TEST(Stationary, ReactionAndDiffusionIsProductPoissonGivenTotals) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0), b = add_species(scene, "B", 1.0), c = add_species(scene, "C", 1.0);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 0.9);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 9.0);
  Trial trial(scene::Sampler::composition_rejection, scene, lattice({10, 10, 10}, true, 1.0, 3));
  for (int s : {a, b, c}) fill(trial.state, s, mean);
  trial.begin();
  trial.run(10.0, 10.0);

  const double short_step = 0.02;
  std::vector<Sample> series(30);
  for (int k = 0; k < 400; ++k) {
    trial.run(trial.t + short_step, short_step);
    for (int v = 0; v < 10; ++v) {
      for (int s = 0; s < 3; ++s) series[3 * v + s].add(static_cast<double>(trial.state.count[3 * (100 * v + 7) + s]));
    }
  }
  const double time = correlation_time(series) * short_step, thinning = 10 * time;
  fmt::print("autocorrelation time {:.3f} s, samples every {:.2f} s\n", time, thinning);

  const int snapshots = 150;
  std::vector<Sample> totals(3);
  std::vector<double> observed(largest * largest * largest, 0.0), expected(observed);
  for (int k = 0; k < snapshots; ++k) {
    trial.run(trial.t + thinning, thinning);
    for (int s = 0; s < 3; ++s) totals[s].add(static_cast<double>(total_count(trial.state, s)) / voxels);
    for (int v = 0; v < voxels; ++v) {
      const std::int64_t* n = trial.state.count.data() + 3 * v;
      ASSERT_LT(std::max({n[0], n[1], n[2]}), largest);
      ++observed[(n[0] * largest + n[1]) * largest + n[2]];
    }
  }
  const double all = log_totals(voxels, 2 * mean * voxels, 2 * mean * voxels);
  std::vector<std::vector<double>> rest(2 * largest, std::vector<double>(2 * largest));
  for (int ac = 0; ac < 2 * largest; ++ac) {
    for (int bc = 0; bc <= ac; ++bc) {
      rest[ac][bc] = rest[bc][ac] = log_totals(voxels - 1, 2 * mean * voxels - ac, 2 * mean * voxels - bc) - all;
    }
  }
  for (int i = 0; i < largest; ++i) {
    for (int j = 0; j < largest; ++j) {
      for (int k = 0; k < largest; ++k) {
        expected[(i * largest + j) * largest + k] =
            snapshots * voxels *
            std::exp(log_poisson(i, mean) + log_poisson(j, mean) + log_poisson(k, mean) + rest[i + k][j + k]);
      }
    }
  }
  double sum = 0;
  for (double one : expected) sum += one;
  EXPECT_NEAR(sum, snapshots * voxels, 1e-3 * snapshots * voxels);
  const double p = chi_square(observed, expected);
  fmt::print("joint law of a voxel: p = {:.3f}\n", p);
  EXPECT_GT(p, 1e-3);
  for (int s : {a, b, c}) {
    fmt::print("mean of {}: {:.5f} +- {:.5f}\n", trial.network.name(s), totals[s].mean(), totals[s].standard_error());
    EXPECT_NEAR(totals[s].mean(), mean, 3 * totals[s].standard_error());
  }
}

}  // namespace
}  // namespace shmoo::rdme
