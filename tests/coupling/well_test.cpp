// Well-mixed scenes against exact laws, by every method; events at the times and states that they name.
#include <gtest/gtest.h>

#include <cmath>

#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

constexpr double six_sigma = 6.0;  // two-sided false alarm 2e-9 for each comparison of a mean

scene::Scene read(const std::string& body, const std::string& numerics = "") {
  return scene::read_scene_text("[compartments.cell]\nvolume = \"2 fL\"\n" + body + numerics, "well.toml");
}

struct Sample {
  double mean = 0, variance = 0, error = 0;
};

// Of a field's last record over realisations, whose ledgers must balance.
Sample sample(const scene::Scene& scene, const std::string& field, std::uint32_t realisations) {
  Laboratory laboratory(scene);
  const std::size_t last = laboratory.experiment->layout().times.size() - 1;
  double sum = 0, squares = 0;
  for (std::uint32_t k = 0; k < realisations; ++k) {
    Outcome outcome;
    const double n = laboratory.realise(k, &outcome).at(field, last)[0];
    EXPECT_TRUE(outcome.balanced);
    sum += n;
    squares += n * n;
  }
  Sample result{sum / realisations};
  result.variance = (squares - sum * result.mean) / (realisations - 1);
  result.error = std::sqrt(result.variance / realisations);
  return result;
}

void expect_law(const Sample& found, double mean, double variance, std::uint32_t realisations) {
  EXPECT_NEAR(found.mean, mean, six_sigma * std::sqrt(variance / realisations));
  // The error of a variance, with room for the fourth moment of a skewed law.
  EXPECT_NEAR(found.variance, variance, six_sigma * variance * std::sqrt(3.0 / realisations));
}

const char* immigration = R"(
[species.X]
initial = "0 molecules"
[[reaction]]
equation = "0 -> X"
forward = "0.5 molecules/fL/s"
[[reaction]]
equation = "X -> 0"
propensity = "0.1*X"
[run]
until = "20 s"
record_every = "5 s"
)";

class EverySampler : public testing::TestWithParam<std::string> {
 protected:
  std::string numerics() const { return "[numerics]\nsampler = \"" + GetParam() + "\"\n"; }
};

TEST_P(EverySampler, ImmigrationAndDeathIsPoisson) {
  const double mean = 10.0 * (1.0 - std::exp(-2.0));
  expect_law(sample(read(immigration, numerics()), "X", 4000), mean, mean, 4000);
}

// Two molecules of the same kind meet in volume V: a = (k/V) n (n - 1). Exact for two: one reaction, exponential.
TEST_P(EverySampler, ConcentrationsAreMoleculesPerVolumeOfTheCompartment) {
  const auto scene = read(R"(
[species.X]
initial = "2 molecules"
[[reaction]]
equation = "2 X -> 0"
forward = "0.1 fL/molecule/s"
[run]
until = "5 s"
)",
                          numerics());
  const double left = std::exp(-0.1 / 2.0 * 2.0 * 5.0);  // P(no reaction)
  expect_law(sample(scene, "X", 4000), 2 * left, 4 * left * (1 - left), 4000);
}

TEST_P(EverySampler, AnEventAtARecordIsSeenInIt) {
  auto scene = read(immigration, "[[event]]\nat = \"20 s\"\nset = { X = \"X + 1000\" }\n" + numerics());
  const double mean = 10.0 * (1.0 - std::exp(-2.0));
  expect_law(sample(scene, "X", 1000), 1000 + mean, mean, 1000);
}

INSTANTIATE_TEST_SUITE_P(Samplers, EverySampler, testing::Values("direct", "composition_rejection", "split"),
                         [](const auto& one) { return one.param; });

// The event sets the rate of birth to 0 at the very birth that makes 20: nothing else ends them.
TEST(Well, ATriggerOnAmountsActsAtOnce) {
  for (const char* sampler : {"direct", "composition_rejection"}) {
    const auto scene = read(R"(
[parameters]
alpha = 10
[species.X]
[[reaction]]
equation = "0 -> X"
propensity = "alpha"
[[event]]
trigger = "X >= 20"
set = { alpha = 0 }
[run]
until = "50 s"
)",
                            std::string("[numerics]\nsampler = \"") + sampler + "\"\n");
    const auto found = sample(scene, "X", 200);
    EXPECT_EQ(found.mean, 20.0) << sampler;
    EXPECT_EQ(found.variance, 0.0) << sampler;
  }
}

TEST(Well, TheSplitSamplerRefusesTriggersOnAmounts) {
  const auto scene =
      read(immigration, "[[event]]\ntrigger = \"X > 5\"\nset = { X = 0 }\n[numerics]\nsampler = \"split\"\n");
  EXPECT_THROW(make_experiment(scene), base::InputError);
}

// dX/dt = -X/10 from 1000 molecules: 100 are reached at t = 10 ln 10, where the event adds 900.
TEST(Well, IntegratedAmountsTriggerAtTheirRoot) {
  const auto scene = read(R"(
[species.X]
initial = "1000 molecules"
method = "deterministic"
[[reaction]]
equation = "X -> 0"
forward = "0.1 1/s"
[[event]]
trigger = "X <= 100"
set = { X = "X + 900" }
[run]
until = "40 s"
[numerics]
tolerance = 1e-10
)");
  Laboratory laboratory(scene);
  const double expected = 1000.0 * std::exp(-0.1 * (40.0 - 10.0 * std::log(10.0)));
  EXPECT_NEAR(laboratory.shared.at("X", 10)[0], expected, 1e-6 * expected);
}

TEST(Well, DefinitionsAndChangedParametersAreRecorded) {
  const auto scene = read(
      immigration, "[definitions]\ntwice = \"2*X\"\n[parameters]\nb = 1\n[[event]]\nat = \"10 s\"\nset = { b = 5 }\n");
  Laboratory laboratory(scene);
  const auto records = laboratory.realise(3);
  for (std::size_t time = 0; time < 5; ++time) {
    EXPECT_EQ(records.observed("twice", time)[0], 2 * records.at("X", time)[0]);
    EXPECT_EQ(records.observed("b", time)[0], time < 2 ? 1.0 : 5.0);
  }
}

// A realisation is the same whichever came before it in the same well.
TEST(Well, ARealisationDependsOnItsNumberOnly) {
  const auto scene = read(immigration);
  Laboratory one(scene), other(scene);
  const auto late = other.realise(7);
  for (std::uint32_t k = 0; k < 7; ++k) one.realise(k);
  EXPECT_EQ(one.realise(7).at("X", 4), late.at("X", 4));
}

TEST(Well, ReactionsBetweenCompartmentsCountEventsOrAreRefused) {
  const std::string two =
      "[compartments.nucleus]\nvolume = \"1 fL\"\n[species.A]\nin = \"cell\"\n[species.B]\nin = \"nucleus\"\n";
  const std::string run = "[run]\nuntil = \"1 s\"\n";
  EXPECT_NO_THROW(make_experiment(read(two + "[[reaction]]\nequation = \"A + B -> 0\"\npropensity = \"A*B\"\n" + run)));
  EXPECT_NO_THROW(make_experiment(read(two + "[[reaction]]\nequation = \"A -> B\"\nforward = \"1 1/s\"\n" + run)));
  EXPECT_THROW(read(two + "[[reaction]]\nequation = \"A + B -> 0\"\nforward = \"1 1/(M s)\"\n" + run),
               base::InputError);
}

}  // namespace
}  // namespace shmoo::coupling
