// A + B <-> C with diffusion on 10^3 voxels: the stationary law is a product of Poisson laws of mean 10, conditioned on
// the two conserved totals A + C and B + C. Samples are a tenth of the run apart from each other, by the measured
// autocorrelation time.
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "ensemble_moments.hpp"
#include "memory_sink.hpp"

namespace {

using namespace shmoo;

constexpr int classes = 5;
int class_of(double n) { return n <= 6 ? 0 : n <= 8 ? 1 : n <= 10 ? 2 : n <= 12 ? 3 : 4; }

// P(a, b, c) of one voxel: Poisson weights times the local limit law of what the other 999 voxels must hold.
double weight(int a, int b, int c) {
  const double var = 19980.0, cov = 9990.0, dx = 20.0 - a - c, dy = 20.0 - b - c;
  const double rest = std::exp(-0.5 * (var * (dx * dx + dy * dy) - 2.0 * cov * dx * dy) / (var * var - cov * cov));
  return gsl_ran_poisson_pdf(unsigned(a), 10) * gsl_ran_poisson_pdf(unsigned(b), 10) *
         gsl_ran_poisson_pdf(unsigned(c), 10) * rest;
}

std::vector<double> class_probabilities() {
  std::vector<double> p(classes * classes * classes, 0.0);
  double total = 0.0;
  for (int a = 0; a < 60; ++a)
    for (int b = 0; b < 60; ++b)
      for (int c = 0; c < 60; ++c) {
        const double w = weight(a, b, c);
        p[std::size_t((class_of(a) * classes + class_of(b)) * classes + class_of(c))] += w;
        total += w;
      }
  for (double& x : p) x /= total;
  return p;
}

// Integrated autocorrelation time of a voxel's count, in records, summed until the correlation drowns in its noise.
double autocorrelation_time(const std::vector<std::vector<double>>& series) {
  double time = 1.0, variance = 0.0;
  const std::size_t n = series.size(), voxels = series[0].size();
  for (std::size_t t = 0; t < n; ++t)
    for (std::size_t i = 0; i < voxels; ++i) variance += std::pow(series[t][i] - 10.0, 2);
  variance /= double(n * voxels);
  for (std::size_t lag = 1; lag < n / 2; ++lag) {
    double c = 0.0;
    for (std::size_t t = 0; t + lag < n; ++t)
      for (std::size_t i = 0; i < voxels; ++i) c += (series[t][i] - 10.0) * (series[t + lag][i] - 10.0);
    c /= double((n - lag) * voxels) * variance;
    if (c < 2.0 / std::sqrt(double((n - lag) * voxels))) break;
    time += 2.0 * c;
  }
  return time;
}

void check(const std::string& sampler) {
  const auto lab =
      test::laboratory("validation/reversible-binding/model.toml", {{"run.until", "\"160 s\""},
                                                                    {"run.record_every", "\"0.5 s\""},
                                                                    {"numerics.splitting_step", "\"5 ms\""},
                                                                    {"numerics.sampler", "\"" + sampler + "\""}});
  const double cpu = test::cpu_seconds();
  std::vector<std::vector<double>> count[3];
  test::Moments total[3];
  coupling::Outcome outcome;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const auto sink = lab.realise(k, &outcome);
    EXPECT_TRUE(outcome.balanced);
    const char* names[] = {"A", "B", "C"};
    for (int s = 0; s < 3; ++s)
      for (std::size_t t = 40; t < lab.experiment->layout().times.size(); ++t) count[s].push_back(sink.at(names[s], t));
  }
  const std::size_t per_run = count[0].size() / 4;
  const double time = autocorrelation_time({count[2].begin(), count[2].begin() + long(per_run)});
  const auto stride = std::size_t(std::ceil(3.0 * time));
  std::vector<double> seen(classes * classes * classes, 0.0);
  double samples = 0.0;
  for (std::size_t t = 0; t < count[0].size(); t += stride) {
    for (int s = 0; s < 3; ++s) {
      double sum = 0.0;
      for (const double n : count[s][t]) sum += n;
      total[s].add({sum / 1000.0});
    }
    for (std::size_t i = 0; i < 1000; ++i) {
      seen[std::size_t((class_of(count[0][t][i]) * classes + class_of(count[1][t][i])) * classes +
                       class_of(count[2][t][i]))] += 1.0;
      samples += 1.0;
    }
  }
  const auto p = class_probabilities();
  double chi2 = 0.0;
  for (std::size_t k = 0; k < p.size(); ++k) chi2 += std::pow(seen[k] - samples * p[k], 2) / (samples * p[k]);
  const double value = gsl_cdf_chisq_Q(chi2, double(p.size() - 1));
  std::printf(
      "%s: autocorrelation time %.2f records of 0.5 s, every %zu-th used, %.0f voxel samples; joint law chi-square "
      "%.1f on %zu, p = %.3g; CPU %.1f s\n",
      sampler.c_str(), time, stride, samples, chi2, p.size() - 1, value, test::cpu_seconds() - cpu);
  for (int s = 0; s < 3; ++s) {
    std::printf("  mean %c = %.4f +- %.4f\n", 'A' + s, total[s].mean(0), total[s].standard_error(0));
    EXPECT_NEAR(total[s].mean(0), 10.0, 3.0 * total[s].standard_error(0));
  }
  EXPECT_GT(value, 1e-3);
}

TEST(ReversibleBinding, JointLawUnderCompositionRejection) { check("composition_rejection"); }
TEST(ReversibleBinding, JointLawUnderTheDirectMethodsReference) {
  const auto lab = test::laboratory(
      "validation/reversible-binding/model.toml",
      {{"run.until", "\"0.2 s\""}, {"run.record_every", "\"0.2 s\""}, {"numerics.sampler", "\"direct\""}});
  test::Moments moments;
  for (std::uint32_t k = 0; k < 4; ++k) {
    coupling::Outcome outcome;
    moments.add(lab.realise(k, &outcome).observed("total_C", 1));
    EXPECT_TRUE(outcome.balanced);
  }
  // The total's standard deviation is sqrt(10000/3) = 58 at most; five of them over four realisations.
  EXPECT_NEAR(moments.mean(0), 10000.0, 5.0 * 58.0 / 2.0);
}
TEST(ReversibleBinding, JointLawUnderTheSplitMethod) { check("split"); }

}  // namespace
