// The yeast cell in a pheromone gradient to t* = 2: the mean of 100 stochastic realisations agrees with the
// deterministic solution along the centre line, and every molecule is accounted for. With CPU seconds per realisation.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "ensemble_moments.hpp"
#include "memory_sink.hpp"

namespace {

using namespace shmoo;

void check(const std::string& model, int realisations, const scene::Overrides& overrides = {}) {
  auto with = [&](const std::string& method) {
    auto all = overrides;
    for (const char* species : {"L", "R", "RL"})
      all.push_back({std::string("species.") + species + ".method", "\"" + method + "\""});
    all.push_back({"run.record_every", "\"0.4 s\""});
    return all;
  };
  double cpu = test::cpu_seconds();
  const auto deterministic = test::laboratory(model, with("deterministic"));
  const double cpu_deterministic = test::cpu_seconds() - cpu;
  cpu = test::cpu_seconds();
  const auto lab = test::laboratory(model, with("stochastic"));
  const double cpu_flow = test::cpu_seconds() - cpu;
  cpu = test::cpu_seconds();
  test::Moments line, bound;
  for (int k = 0; k < realisations; ++k) {
    coupling::Outcome outcome;
    const auto sink = lab.realise(std::uint32_t(k), &outcome);
    EXPECT_TRUE(outcome.balanced) << "realisation " << k;
    line.add(sink.observed("L_centre_line", 2));
    bound.add(sink.observed("RL_total", 2));
  }
  const double each = (test::cpu_seconds() - cpu) / realisations;
  const auto& mean = deterministic.shared.observed("L_centre_line", 2);
  std::size_t points = 0, close = 0;
  for (std::size_t b = 0; b < mean.size(); ++b) {
    const double se = line.standard_error(b);
    if (se == 0.0) continue;  // inside the cell, where no L can be
    ++points;
    if (std::abs(line.mean(b) - mean[b]) <= 3.0 * se) ++close;
  }
  std::printf(
      "%s: %zu particles, L on the centre line within 3 s.e. at %zu of %zu points; RL %.1f +- %.1f (deviation %.1f), "
      "deterministic %.1f; CPU s: flow %.1f once, %.2f per realisation, deterministic with its flow %.1f\n",
      model.c_str(), lab.experiment->particles(), close, points, bound.mean(0), bound.standard_error(0),
      std::sqrt(bound.variance(0)), deterministic.shared.observed("RL_total", 2)[0], cpu_flow, each, cpu_deterministic);
  EXPECT_GE(double(close), 0.95 * double(points));
}

TEST(YeastGradient, AtThePublishedResolution) { check("yeast-gradient/published-4um.toml", 100); }
TEST(YeastGradient, AtTwoMicrometres) { check("yeast-gradient/model.toml", 20, {{"domain.spacing", "\"2 um\""}}); }
TEST(YeastGradient, AtOneMicrometre) { check("yeast-gradient/model.toml", 100); }

}  // namespace
