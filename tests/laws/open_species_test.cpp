// Species that enter and leave through open sides with their particles: what the side gives is what is inside, the
// ledger accounts for every molecule, and molecules are Poisson in number.
#include <gtest/gtest.h>
#include <omp.h>

#include <cmath>

#include "memory_sink.hpp"

namespace {

using namespace shmoo;

// A stream of 1 m/s in a channel of 1 m by 0.5 m; what it holds reaches the far end after a second.
const std::string channel = R"toml(
title = "Species enter and leave"
dimension = 2
depth = "1 m"
[domain]
size = ["1 m", "0.5 m"]
spacing = "0.05 m"
boundary = { x_min = { type = "inlet", velocity = ["1 m/s", "0 m/s"], species = { S = "40000 molecules/m^3", D = "40000 molecules/m^3" } }, x_max = "outlet", y = "slip" }
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.01 Pa s"
[flow]
initial_velocity = ["1 m/s", "0 m/s"]
[species.S]
diffusivity = "0.01 m^2/s"
method = "stochastic"
[species.D]
diffusivity = "0.01 m^2/s"
method = "deterministic"
[species.P]
diffusivity = "0 m^2/s"
method = "stochastic"
[[reaction]]
equation = "S -> S + P"
forward = "1 1/s"
[[observable]]
name = "S"
type = "count"
species = "S"
[[observable]]
name = "D"
type = "count"
species = "D"
[[observable]]
name = "D_along"
type = "species_line"
species = "D"
axis = "x"
through = ["0 m", "0.25 m"]
[run]
until = "4 s"
record_every = "1 s"
)toml";

const double full = 40000 * 0.5;  // molecules in the domain

TEST(OpenSpecies, FillTheDomainAndLeaveIt) {
  const test::Laboratory lab(scene::read_scene_text(channel, "channel.toml", {}));
  coupling::Outcome outcome;
  const auto sink = lab.realise(0, &outcome);
  EXPECT_TRUE(outcome.balanced);
  EXPECT_NEAR(sink.observed("D", 4)[0], full, 0.03 * full);
  EXPECT_NEAR(sink.observed("S", 4)[0], full, 0.03 * full + 5.0 * std::sqrt(full));
  for (const double C : sink.observed("D_along", 4)) EXPECT_NEAR(C, 40000.0, 0.02 * 40000.0);
  const auto& account = outcome.ledger.counts[2];
  EXPECT_NEAR(double(account.entered), 4.0 * full, 0.03 * 4.0 * full);
  EXPECT_GT(account.left, 0);
}

// A front that spreads by diffusion: D after half a second is the mean of S, and what it should be.
TEST(OpenSpecies, TheMeanOfTheMoleculesIsTheDeterministicAmount) {
  const test::Laboratory lab(
      scene::read_scene_text(channel, "channel.toml", {{"run.until", "\"0.5 s\""}, {"run.record_every", "\"0.5 s\""}}));
  double sum = 0.0;
  const int realisations = 20;
  double exact = 0.0;
  for (int k = 0; k < realisations; ++k) {
    const auto sink = lab.realise(std::uint32_t(k));
    sum += sink.observed("S", 1)[0];
    exact = sink.observed("D", 1)[0];
  }
  EXPECT_NEAR(exact, 0.5 * full, 0.03 * full);
  EXPECT_NEAR(sum / realisations, exact, 5.0 * std::sqrt(exact / realisations));
}

// Species are numbered in the order of their names: D, P, S.
// Products of what entered leave with their particles.
TEST(OpenSpecies, ProductsLeaveToo) {
  const test::Laboratory lab(scene::read_scene_text(channel, "channel.toml", {}));
  coupling::Outcome outcome;
  lab.realise(1, &outcome);
  EXPECT_TRUE(outcome.balanced);
  EXPECT_GT(outcome.ledger.counts[1].left, 0);
  EXPECT_EQ(outcome.ledger.counts[1].entered, 0);
}

TEST(OpenSpecies, HaveTheSameBitsForAnyNumberOfThreads) {
  std::vector<std::vector<double>> found;
  for (const int threads : {1, 2, 5}) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(threads);
    const test::Laboratory lab(scene::read_scene_text(channel, "channel.toml",
                                                      {{"run.until", "\"0.5 s\""}, {"run.record_every", "\"0.5 s\""}}));
    const auto sink = lab.realise(3);
    omp_set_num_threads(before);
    auto values = sink.at("S", 1);
    const auto& amounts = sink.at("D", 1);
    values.insert(values.end(), amounts.begin(), amounts.end());
    found.push_back(std::move(values));
  }
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

// One message per mistake.
void expect_refusal(const std::string& from, const std::string& to, const std::string& words) {
  std::string text = channel;
  ASSERT_NE(text.find(from), std::string::npos);
  text.replace(text.find(from), from.size(), to);
  try {
    scene::read_scene_text(text, "channel.toml", {});
    ADD_FAILURE() << "was read: " << to;
  } catch (const base::InputError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(OpenSides, RefuseWhatTheyCannotDo) {
  expect_refusal("\"1 m/s\", \"0 m/s\"], species", "\"-1 m/s\", \"0 m/s\"], species", "must be positive");
  expect_refusal("velocity = [\"1 m/s\", \"0 m/s\"], ", "", "either a 'velocity' or a 'pressure'");
  expect_refusal("velocity = [\"1 m/s\", \"0 m/s\"], ", "velocity = [\"u\", \"0 m/s\"], ", "u");
  expect_refusal("y = \"slip\"", "y = \"outlet\"", "one axis");
  expect_refusal("y = \"slip\"", "y = \"inlet\"", "inlet");
  expect_refusal("y = \"slip\"", "y = { type = \"slip\", pressure = \"1 Pa\" }", "pressure");
  expect_refusal("[run]\n", "[effects]\nflow = false\n[run]\n", "open side");
  expect_refusal("[run]\n", "[numerics]\nsteady_tolerance = 1e-3\n[run]\n", "steady_tolerance");
  expect_refusal("S = \"40000", "Q = \"40000", "Q");
  expect_refusal("type = \"count\"\nspecies = \"D\"", "type = \"wall_force\"\ncomponent = \"x\"\nside = \"y_min\"",
                 "mirror");
}

}  // namespace
