// Steady diffusion in a plate with one hot side (thesis Table 2.2), theirs beside ours, on a lattice and on disordered
// particles.
#include <gsl/gsl_cdf.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "ensemble_moments.hpp"
#include "memory_sink.hpp"
#include "start_from.hpp"

namespace {

using namespace shmoo;

// Thesis Eq. 2.33 in a form that does not overflow.
double plate(double x, double y) {
  double c = 0.0;
  for (int n = 1; n < 2000; n += 2) {
    const double k = n * std::numbers::pi;
    const double ratio = std::exp(k * (y - 1.0)) * (1.0 - std::exp(-2.0 * k * y)) / (1.0 - std::exp(-2.0 * k));
    c += 4.0 / k * std::sin(k * x) * ratio;
    if (ratio < 1e-17) break;
  }
  return c;
}

bool near_hot_corner(double x, double y) { return std::hypot(x, y - 1.0) < 0.1 || std::hypot(x - 1.0, y - 1.0) < 0.1; }

struct Level {
  int n;
  double c0, sph, ssa;  // published, Eq. 2.31
};
constexpr Level levels[] = {
    {17, 2.89e5, 2.337e-4, 2.902e-4}, {33, 1.089e6, 5.818e-5, 1.294e-4}, {65, 4.225e6, 1.438e-5, 2.043e-4}};

scene::Overrides plate_at(const Level& level, const std::string& method, double jitter, double reach) {
  const auto number = [](double x, const char* unit) {
    char text[64];
    std::snprintf(text, sizeof text, *unit ? "\"%.17g %s\"" : "%.17g", x, unit);
    return std::string(text);
  };
  return {{"domain.spacing", number(1.0 / level.n, "m")},
          {"domain.jitter", number(jitter, "")},
          {"numerics.reach", number(reach, "")},
          {"boundary.0.value", number(level.c0, "molecules/m^3")},
          {"species.C.initial", number(0.25 * level.c0, "molecules/m^3")},
          {"species.C.method", "\"" + method + "\""}};
}

double order(double before, double error, double refinement) { return std::log(before / error) / std::log(refinement); }

double rms(const test::Laboratory& lab, const std::vector<double>& n, double c0, bool all) {
  const auto places = lab.experiment->start_position();
  const auto& volume = lab.shared.at("volume", 0);
  double sum = 0.0;
  std::size_t points = 0;
  for (std::size_t i = 0; i < n.size(); ++i) {
    const double x = places[i][0], y = places[i][1];
    if (!all && near_hot_corner(x, y)) continue;
    sum += std::pow(n[i] / (volume[i] * c0) - plate(x, y), 2);
    ++points;
  }
  return std::sqrt(sum / double(points));
}

struct PlateErrors {
  double rms = 0, published = 0;  // outside the hot corners; Eq. 2.31
  double cpu = 0;                 // [s]
};

PlateErrors errors(const Level& level, double jitter, double reach) {
  const double cpu = test::cpu_seconds();
  const auto lab =
      test::laboratory("validation/diffusion-2d/model.toml", plate_at(level, "deterministic", jitter, reach));
  const auto& n = lab.shared.at("C", 1);
  return {rms(lab, n, level.c0, false), rms(lab, n, level.c0, true) / level.n, test::cpu_seconds() - cpu};
}

// Kernel weights on the lattice, Voronoi faces on jittered particles. On the lattice the faces are the nearest
// neighbours, which are all that a reach of 1.2 sees: that is the lattice the jittered particles are compared with.
TEST(PublishedTables, DiffusionInAPlate) {
  std::vector<PlateErrors> kernel, jittered;
  std::printf(
      "   N    reach 2: rms, order, Eq. 2.31 (paper), CPU s    faces: rms    jitter 0.2: rms, times faces, times "
      "reach 2, order from 17^2\n");
  for (const auto& level : levels) {
    kernel.push_back(errors(level, 0.0, 2.0));
    jittered.push_back(errors(level, 0.2, 2.0));
    const auto& now = kernel.back();
    const double faces = errors(level, 0.0, 1.2).rms, disordered = jittered.back().rms;
    // At 17^2 the cut discs are but two particles wide.
    const double refinement = level.n / (0.5 * (level.n + 1)), whole = level.n / 17.0;
    const double last = kernel.size() > 1 ? order(kernel[kernel.size() - 2].rms, now.rms, refinement) : 0.0;
    const double overall = whole > 1.0 ? order(jittered.front().rms, disordered, whole) : 0.0;
    std::printf("%3d^2  %.3e  %5.2f  %.3e (%.3e)  %.2f  %.3e  %.3e  %.2f  %.2f  %.2f\n", level.n, now.rms, last,
                now.published, level.sph, now.cpu, faces, disordered, disordered / faces, disordered / now.rms,
                overall);
    EXPECT_LE(now.published, level.sph);
    EXPECT_LE(disordered, 3.0 * faces);
    if (whole > 1.0) {
      EXPECT_GE(last, 1.8);
      EXPECT_GE(overall, 1.8);
    }
  }
}

// Each realisation starts from the deterministic steady state and runs for ten seconds, four relaxation times of the
// variance.
TEST(PublishedTables, StochasticDiffusionInAPlate) {
  for (const auto& level : levels) {
    const double cpu = test::cpu_seconds();
    const auto steady =
        test::laboratory("validation/diffusion-2d/model.toml", plate_at(level, "deterministic", 0.0, 1.2));
    auto overrides = plate_at(level, "stochastic", 0.0, 1.2);
    overrides.push_back({"run.until", "\"10 s\""});
    overrides.push_back({"run.record_every", "\"10 s\""});
    overrides.push_back({"numerics.sampler", "\"split\""});
    auto scene =
        scene::read_scene(std::string(SHMOO_SOURCE_DIR) + "/models/validation/diffusion-2d/model.toml", overrides);
    test::start_from(steady, 1, 1.0 / level.n, scene);
    const auto& mean = steady.shared.at("C", 1);
    const auto places = steady.experiment->start_position();
    const auto& volume = steady.shared.at("volume", 0);
    const test::Laboratory lab(std::move(scene));
    test::Moments moments;
    const int realisations = 50;
    for (int k = 0; k < realisations; ++k) moments.add(lab.realise(std::uint32_t(k)).at("C", 1));
    double chi2 = 0.0, error = 0.0;
    std::size_t close = 0;
    for (std::size_t i = 0; i < mean.size(); ++i) {
      const double z = (moments.mean(i) - mean[i]) / std::sqrt(mean[i] / realisations);
      chi2 += z * z;
      if (std::abs(z) <= 3.0) ++close;
      error += std::pow(moments.mean(i) / (volume[i] * level.c0) - plate(places[i][0], places[i][1]), 2);
    }
    const double p = gsl_cdf_chisq_Q(chi2, double(mean.size()));
    std::printf(
        "%3d^2  SSA Eq. 2.31: %.3e (paper %.3e); within 3 s.e.: %zu of %zu; chi-square p = %.3g; CPU %.1f s for %d\n",
        level.n, std::sqrt(error) / double(mean.size()), level.ssa, close, mean.size(), p, test::cpu_seconds() - cpu,
        realisations);
    EXPECT_GE(double(close), 0.99 * double(mean.size()));
    EXPECT_GT(p, 1e-3);
    EXPECT_LE(std::sqrt(error) / double(mean.size()), level.ssa);
  }
}

}  // namespace
