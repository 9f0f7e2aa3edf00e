// The published tables of diffusion (thesis Tables 2.1 and 2.2), theirs beside ours, with CPU seconds; and whether the
// mean of the stochastic method is the deterministic solution.
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "ensemble_moments.hpp"
#include "memory_sink.hpp"

namespace {

using namespace shmoo;
using test::Moments;

// Thesis Eq. 2.30.
double slab(double x, double t) {
  double c = 1.0 - x;
  for (int n = 1; n < 400; ++n) {
    const double k = n * std::numbers::pi;
    c -= 2.0 / k * std::sin(k * x) * std::exp(-k * k * 0.1 * t);
  }
  return c;
}

scene::Overrides slab_at(int cells, double c0, const std::string& method) {
  const double dx = 1.0 / cells;
  const auto exact = [](double x) {
    char text[64];
    std::snprintf(text, sizeof text, "\"%.17g m\"", x);
    return std::string(text);
  };
  char value[64];
  std::snprintf(value, sizeof value, "\"%.17g molecules/m^3\"", c0);
  return {{"domain.origin", "[" + exact(-0.5 * dx) + "]"},
          {"domain.size", "[" + exact(1.0 + dx) + "]"},
          {"domain.spacing", exact(dx)},
          {"boundary.0.value", value},
          {"species.C.method", "\"" + method + "\""},
          {"numerics.sampler", "\"split\""},  // exact for pure diffusion at any step, and fast
          {"numerics.tolerance", "1e-9"}};
}

struct Errors {
  double rms = 0, published_norm = 0;  // sqrt(mean e^2)/C0 and Eq. 2.31
};

Errors error_of(const std::vector<double>& n, double dx, double c0, double t) {
  double sum = 0.0;
  for (std::size_t i = 1; i + 1 < n.size(); ++i) sum += std::pow(n[i] / (dx * c0) - slab(double(i) * dx, t), 2);
  return {std::sqrt(sum / double(n.size())), std::sqrt(sum) / double(n.size())};
}

TEST(PublishedTables, DiffusionInASlab) {
  const double published_sph[] = {6.617e-4, 4.669e-4, 3.764e-4}, published_ssa[] = {8.514e-4, 5.278e-4, 8.070e-4};
  double before = 0.0;
  std::size_t all_points = 0, all_close = 0;
  std::printf("  dx   time   SPH rms    SPH 2.31 (paper)      SSA rms    SSA 2.31 (paper)      SSA within 3 s.e.  p\n");
  for (int level = 0; level < 3; ++level) {
    const int cells = 16 << level;
    const double dx = 1.0 / cells, c0 = 1.6e5 * (1 << level);
    double cpu = test::cpu_seconds();
    const auto sph = test::laboratory("validation/diffusion-1d/model.toml", slab_at(cells, c0, "deterministic"));
    const double cpu_sph = test::cpu_seconds() - cpu;
    cpu = test::cpu_seconds();
    const auto ssa = test::laboratory("validation/diffusion-1d/model.toml", slab_at(cells, c0, "stochastic"));
    const auto& times = ssa.experiment->layout().times;
    std::vector<Moments> moments(times.size());
    const int realisations = ssa.experiment->scene().run.realisations;
    for (int k = 0; k < realisations; ++k) {
      const auto sink = ssa.realise(std::uint32_t(k));
      for (std::size_t t = 0; t < times.size(); ++t) moments[t].add(sink.at("C", t));
    }
    const double cpu_ssa = test::cpu_seconds() - cpu;
    std::size_t points = 0, close = 0;
    double chi2 = 0.0;
    for (std::size_t t = 1; t < times.size(); ++t) {
      const auto& mean_field = sph.shared.at("C", t);
      std::vector<double> mean(mean_field.size());
      for (std::size_t i = 0; i < mean.size(); ++i) {
        mean[i] = moments[t].mean(i);
        if (mean_field[i] < 0.5) continue;
        ++points;
        // Counts from a Poisson reservoir are Poisson: the variance of the mean is known.
        const double z = (mean[i] - mean_field[i]) / std::sqrt(mean_field[i] / realisations);
        if (std::abs(z) <= 3.0) ++close;
      }
      const auto e_sph = error_of(mean_field, dx, c0, times[t]), e_ssa = error_of(mean, dx, c0, times[t]);
      std::printf("1/%-3d %5.2f  %.3e  %.3e (%.3e)  %.3e  %.3e (%.3e)\n", cells, times[t], e_sph.rms,
                  e_sph.published_norm, published_sph[level], e_ssa.rms, e_ssa.published_norm, published_ssa[level]);
      if (t + 1 < times.size()) continue;
      EXPECT_LE(e_sph.published_norm, 0.1 * published_sph[level]);
      if (level > 0) {
        EXPECT_GE(std::log2(before / e_sph.rms), 1.8);
      }
      before = e_sph.rms;
    }
    // The global chi-square uses records a mixing time of a voxel apart; times of one voxel correlate little beyond
    // that.
    const std::size_t last = times.size() - 1;
    std::size_t degrees = 0;
    for (std::size_t i = 1; i + 1 < moments[last].size(); ++i) {
      const double expected = sph.shared.at("C", last)[i];
      chi2 += std::pow(moments[last].mean(i) - expected, 2) / (expected / realisations);
      ++degrees;
    }
    const double p = gsl_cdf_chisq_Q(chi2, double(degrees));
    std::printf("1/%-3d  CPU s: SPH %.3f, SSA %.2f (%d realisations); within 3 s.e.: %zu of %zu; chi-square p = %.3g\n",
                cells, cpu_sph, cpu_ssa, realisations, close, points, p);
    all_points += points;
    all_close += close;
    EXPECT_GT(p, 1e-3);
  }
  std::printf("within 3 s.e. in all: %zu of %zu\n", all_close, all_points);
  EXPECT_GE(double(all_close), 0.99 * double(all_points));
}

}  // namespace
