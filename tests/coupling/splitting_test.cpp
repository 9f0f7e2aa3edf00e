// The splitting step follows from an error estimate whose order is that of the splitting.
#include "coupling/splitting.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "coupling/splitting_twin.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

// A and B meet and part while they diffuse; `a` says how A is treated.
scene::Scene binding(const std::string& a, const scene::Overrides& overrides = {}) {
  return scene::read_scene_text(R"toml(
title = "Binding"
dimension = 1
cross_section = "1 m^2"
[domain]
size = ["10 m"]
spacing = "1 m"
[materials.medium]
type = "still"
[species.A]
diffusivity = "1 m^2/s"
initial = "1000 molecules/m^3"
method = ")toml" + a + R"toml("
[species.B]
diffusivity = "0.3 m^2/s"
initial = "700 molecules/m^3"
[species.C]
initial = "0 molecules/m^3"
[[reaction]]
equation = "A + B <-> C"
forward = "2e-3 m^3/(s molecule)"
backward = "0.5 1/s"
[numerics]
sampler = "split"
[run]
until = "20 s"
record_every = "20 s"
)toml",
                                "binding.toml", overrides);
}

// Errors of a twin at three steps, each half of the one before.
std::vector<double> orders(const scene::Scene& scene) {
  const rdme::Network network(scene);
  SplittingTwin twin(scene, network, {1000.0, 700.0, 700.0});
  std::vector<std::vector<double>> found;
  for (const int steps : {32, 64, 128, 256}) found.push_back(twin.amounts(4.0, steps));
  std::vector<double> differences;
  for (std::size_t k = 0; k + 1 < found.size(); ++k) {
    double largest = 0;
    for (std::size_t at = 0; at < found[k].size(); ++at)
      largest = std::max(largest, std::abs(found[k][at] - found[k + 1][at]));
    differences.push_back(largest);
  }
  return {std::log2(differences[0] / differences[1]), std::log2(differences[1] / differences[2])};
}

const scene::Overrides fine{{"numerics.splitting_tolerance", "1e-6"}};
const scene::Overrides fine_lie{{"numerics.splitting_tolerance", "1e-6"}, {"numerics.splitting", "\"lie\""}};

TEST(SplittingTwin, StrangIsOfSecondOrderWhereReactionsAndDiffusionTakeTurns) {
  for (const double order : orders(binding("stochastic", fine))) EXPECT_NEAR(order, 2.0, 0.15);
}

TEST(SplittingTwin, StrangIsOfSecondOrderInMixedNetworks) {
  for (const char* a : {"deterministic", "langevin"})
    for (const double order : orders(binding(a, fine))) EXPECT_NEAR(order, 2.0, 0.15) << a;
}

TEST(SplittingTwin, LieIsOfFirstOrderInMixedNetworks) {
  for (const char* a : {"deterministic", "langevin"})
    for (const double order : orders(binding(a, fine_lie))) EXPECT_NEAR(order, 1.0, 0.15) << a;
}

Step step_of(const scene::Scene& scene) {
  const rdme::Network network(scene);
  return splitting_step(scene, network, {1000.0, 700.0, 700.0});
}

TEST(SplittingStep, KeepsTheTolerance) {
  double before = 1e9;
  for (const char* tolerance : {"1e-2", "1e-3", "1e-4"}) {
    const Step step = step_of(binding("stochastic", {{"numerics.splitting_tolerance", tolerance}}));
    EXPECT_LE(step.error, std::stod(tolerance));
    EXPECT_GT(step.error, 0.02 * std::stod(tolerance)) << "a step four times as long would do";
    EXPECT_LT(step.value, before);
    EXPECT_NE(step.why.find("order 2"), std::string::npos) << step.why;
    before = step.value;
  }
}

TEST(SplittingStep, IsAsLongAsItLikesWhereNothingIsSplit) {
  EXPECT_TRUE(std::isinf(step_of(binding("stochastic", {{"numerics.sampler", "\"direct\""}})).value));
  const scene::Overrides smooth{{"species.B.method", "\"deterministic\""}, {"species.C.method", "\"deterministic\""}};
  EXPECT_TRUE(std::isinf(step_of(binding("deterministic", smooth)).value));
}

TEST(SplittingStep, FallsBackWhereATwinCannotBeFollowed) {
  const scene::Overrides blows_up{{"reaction", R"toml([{ equation = "A + B -> C", forward = "2e-3 m^3/(s molecule)" },
                           { equation = "2 A -> 3 A", forward = "2e-3 m^3/(s molecule)" }])toml"}};
  const Step step = step_of(binding("stochastic", blows_up));
  EXPECT_NE(step.why.find("cannot be followed"), std::string::npos) << step.why;
  EXPECT_GT(step.value, 0.0);
}

}  // namespace
}  // namespace shmoo::coupling
