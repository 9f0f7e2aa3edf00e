// Species that live in an elastic solid, and soften it.
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "coupling/laboratory.hpp"
#include "scene/read.hpp"

namespace {

using namespace shmoo;

// A bar held at one end that starts to swing; `elastic` is its elasticity, `species` what lives in it.
std::string bar(const std::string& elastic, const std::string& species) {
  return R"toml(dimension = 2
depth = "1 m"
[domain]
size = ["2 m", "2 m"]
spacing = "0.1 m"
[materials.bar]
type = "solid"
density = "1000 kg/m^3"
fixed = { shape = "box", lower = ["0 m", "0 m"], upper = ["0.2 m", "2 m"] }
initial_velocity = ["0 m/s", "0.2 m/s"]
)toml" + elastic +
         R"toml(
[[region]]
material = "bar"
shape = "box"
lower = ["0 m", "0.8 m"]
upper = ["1 m", "1.2 m"]
[[observable]]
name = "tip"
type = "displacement"
component = "y"
shape = "box"
lower = ["0.9 m", "0.8 m"]
upper = ["1 m", "1.2 m"]
[run]
until = "0.2 s"
record_every = "0.02 s"
)toml" + species;
}

double tip(const coupling::Laboratory& lab, const coupling::MemorySink& sink, std::size_t time) {
  const auto& from = lab.shared.observables().contains("tip") ? lab.shared : sink;
  return from.observed("tip", time).at(0);
}

std::vector<double> swing(const std::string& text) {
  const coupling::Laboratory lab(scene::read_scene_text(text, "bar.toml"));
  coupling::Outcome outcome;
  const auto sink = lab.realise(0, &outcome);
  EXPECT_TRUE(outcome.balanced);
  std::vector<double> course;
  for (std::size_t k = 0; k <= 10; ++k) course.push_back(tip(lab, sink, k));
  return course;
}

std::string enzyme(const std::string& method, const std::string& diffusivity = "0.01 m^2/s") {
  return "[species.E]\nin = \"bar\"\nmethod = \"" + method + "\"\ndiffusivity = \"" + diffusivity +
         "\"\ninitial = \"1000 molecules/m^3\"\n";
}

const std::string stiff = "shear_modulus = \"1e5 Pa\"\npoisson_ratio = 0.3\n";
const std::string half = "shear_modulus = \"0.5e5 Pa\"\npoisson_ratio = 0.39285714285714285\n";  // the same K
const std::string softened = stiff + "softening = { species = \"E\", coefficient = \"5e-4 m^3/molecule\" }\n";

TEST(Softening, HalvesTheModulusWhereItSays) {
  const auto soft = swing(bar(softened, enzyme("deterministic"))), wanted = swing(bar(half, ""));
  const auto hard = swing(bar(stiff, ""));
  for (std::size_t k = 1; k <= 10; ++k) EXPECT_NEAR(soft[k], wanted[k], 1e-3 * std::abs(wanted[10])) << k;
  EXPECT_GT(std::abs(hard[10] - wanted[10]), 0.01 * std::abs(wanted[10]));
}

TEST(Softening, AtZeroChangesNothing) {
  const auto none = stiff + "softening = { species = \"E\", coefficient = \"0 m^3/molecule\" }\n";
  const auto a = swing(bar(none, enzyme("deterministic"))), b = swing(bar(stiff, enzyme("deterministic")));
  for (std::size_t k = 1; k <= 10; ++k) EXPECT_NEAR(a[k], b[k], 1e-3 * std::abs(b[10]));
}

TEST(Softening, FollowsEveryRealisationOfAStochasticSpecies) {
  const coupling::Laboratory lab(scene::read_scene_text(bar(softened, enzyme("stochastic")), "bar.toml"));
  const auto first = lab.realise(0), again = lab.realise(0), other = lab.realise(1);
  EXPECT_EQ(first.observed("tip", 10), again.observed("tip", 10));
  EXPECT_NE(first.observed("tip", 10), other.observed("tip", 10));
}

TEST(Softening, RefusesASpeciesFromElsewhere) {
  const std::string homeless = "[species.E]\nin = \"gel\"\ndiffusivity = \"0 m^2/s\"\ninitial = \"1 molecules/m^3\"\n";
  EXPECT_THROW(scene::read_scene_text(bar(softened, homeless + "[materials.gel]\ntype = \"still\"\n"), "bar.toml"),
               base::InputError);
}

}  // namespace
