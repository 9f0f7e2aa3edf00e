// Counts, Langevin amounts and smooth amounts in one well, against exact moments.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

constexpr int realisations = 1000;
constexpr double errors_allowed = 4.5;  // standard errors: a false alarm in 1.5 10^5

// A gene that is switched on and off makes protein, and protein makes a dye that is not looked at one by one.
scene::Scene telegraph(const std::string& protein, const std::string& dye) {
  return scene::read_scene_text(R"toml(
title = "A gene that is switched"
[compartments.cell]
volume = "1 um^3"
[species.On]
initial = "1 molecules"
[species.Off]
[species.P]
initial = "500 molecules"
method = ")toml" + protein + R"toml("
[species.D]
initial = "50 molecules"
method = ")toml" + dye + R"toml("
[[reaction]]
equation = "On <-> Off"
forward = "0.5 1/s"
backward = "0.5 1/s"
[[reaction]]
equation = "On -> On + P"
forward = "1000 1/s"
[[reaction]]
equation = "P -> nothing"
forward = "1 1/s"
[[reaction]]
equation = "P -> P + D"
forward = "0.1 1/s"
[[reaction]]
equation = "D -> nothing"
forward = "1 1/s"
[run]
until = "9 s"
record_every = "9 s"
)toml",
                                "telegraph.toml");
}

struct Moments {
  double mean = 0, variance = 0, kurtosis = 0;
};

Moments protein(const scene::Scene& scene) {
  const Laboratory lab(scene);
  std::vector<double> found;
  for (std::uint32_t k = 0; k < realisations; ++k) {
    Outcome outcome;
    found.push_back(lab.realise(k, &outcome).at("P", 1).front());
    EXPECT_TRUE(outcome.balanced);
    EXPECT_GE(found.back(), 0.0);
  }
  Moments moments;
  for (const double n : found) moments.mean += n / realisations;
  double fourth = 0;
  for (const double n : found) {
    moments.variance += std::pow(n - moments.mean, 2) / realisations;
    fourth += std::pow(n - moments.mean, 4) / realisations;
  }
  moments.kurtosis = fourth / (moments.variance * moments.variance);
  return moments;
}

// Mean k p/d; variance mean + (k/d)^2 p (1 - p) d/(d + on + off) (Peccoud & Ycart 1995), here 500 and 500 + 125000.
void expect_exact(const Moments& found) {
  const double variance = 500 + 1e6 * 0.25 / 2;
  EXPECT_NEAR(found.mean, 500, errors_allowed * std::sqrt(variance / realisations));
  EXPECT_NEAR(found.variance, variance, errors_allowed * variance * std::sqrt((found.kurtosis - 1) / realisations));
}

TEST(Hybrid, AGeneByEventsAndItsProteinWithSmoothNoise) {
  expect_exact(protein(telegraph("langevin", "deterministic")));
}

TEST(Hybrid, AllByEventsIsTheSame) { expect_exact(protein(telegraph("stochastic", "stochastic"))); }

}  // namespace
}  // namespace shmoo::coupling
