#include <fmt/format.h>

#include <numeric>

#include "coupling/laboratory.hpp"
#include "run/verify/case.hpp"
#include "run/verify/jump_chain.hpp"
#include "scene/read.hpp"

namespace shmoo::run::verify {
namespace {

using coupling::Laboratory;

// Each realisation gives one number of `species` over all voxels, at the end.
struct Experiment {
  std::string model;
  std::string species;
  std::vector<double> law;  // of that number
  int realisations = 4000;
  std::vector<std::string> samplers{"direct", "composition_rejection", "split"};
};

constexpr double least_chance = 1e-6;

std::vector<Finding> judge(const Experiment& experiment, std::uint64_t seed) {
  std::vector<Finding> findings;
  for (const auto& sampler : experiment.samplers) {
    const Laboratory lab(
        scene::read_scene_text(experiment.model, "case.toml",
                               {{"numerics.sampler", "\"" + sampler + "\""}, {"run.seed", std::to_string(seed)}}));
    std::vector<std::size_t> numbers;
    double unbalanced = 0.0;
    for (int k = 0; k < experiment.realisations; ++k) {
      coupling::Outcome outcome;
      const auto sink = lab.realise(std::uint32_t(k), &outcome);
      const auto& n = sink.at(experiment.species, 1);
      numbers.push_back(std::size_t(std::accumulate(n.begin(), n.end(), 0.0)));
      unbalanced += !outcome.balanced;
    }
    findings.push_back(at_least("chance of numbers further from the law, " + sampler,
                                chance_of(experiment.law, numbers), least_chance));
    findings.push_back(exactly("ledgers that do not balance, " + sampler, unbalanced, 0.0));
  }
  return findings;
}

// `voxels` of one cubic metre in a row.
std::string row_of(int voxels, const std::string& chemistry, const std::string& until, const std::string& step) {
  return fmt::format(
      "title = \"A row of voxels\"\ndimension = 1\ncross_section = \"1 m^2\"\n[domain]\nsize = [\"{} m\"]\nspacing = "
      "\"1 "
      "m\"\n[materials.medium]\ntype = \"still\"\n{}[numerics]\nreach = 1.2\nsplitting_step = \"{}\"\nlimits = "
      "\"warn\"\n[run]\nuntil = \"{}\"\nrecord_every = \"{}\"\n",
      voxels, chemistry, step, until, until);
}

std::string species(const std::string& name, int initial, const std::string& diffusivity = "1 m^2/s") {
  return fmt::format("[species.{}]\ndiffusivity = \"{}\"\ninitial = \"{} molecules/m^3\"\n", name, diffusivity,
                     initial);
}

std::string reaction(const std::string& equation, const std::string& forward, const std::string& backward = "") {
  const std::string back = backward.empty() ? "" : "backward = \"" + backward + "\"\n";
  return fmt::format("[[reaction]]\nequation = \"{}\"\nforward = \"{}\"\n{}", equation, forward, back);
}

Experiment birth_and_death() {
  std::vector<ChainJump> jumps;
  for (std::size_t n = 0; n < 80; ++n) {
    jumps.push_back({n, n + 1, 20.0});
    if (n > 0) jumps.push_back({n, n - 1, double(n)});
  }
  return {row_of(1, species("X", 3) + reaction("nothing <-> X", "20 molecules/(m^3 s)", "1 1/s"), "1.5 s", "1 s"), "X",
          chain_law(80, jumps, 3, 1.5)};
}

Experiment batches() {
  std::vector<ChainJump> jumps;
  for (std::size_t n = 0; n < 120; ++n) {
    jumps.push_back({n, n + 5, 3.0});
    if (n > 0) jumps.push_back({n, n - 1, double(n)});
  }
  return {
      row_of(1, species("X", 0) + reaction("nothing -> 5 X", "3 molecules/(m^3 s)") + reaction("X -> nothing", "1 1/s"),
             "2 s", "1 s"),
      "X", chain_law(120, jumps, 0, 2.0)};
}

// 2 M <-> D from 30 M: k M (M - 1) and back.
Experiment dimers() {
  std::vector<ChainJump> jumps;
  for (std::size_t d = 0; d <= 15; ++d) {
    const double m = 30.0 - 2.0 * double(d);
    if (d < 15) jumps.push_back({d, d + 1, 0.02 * m * (m - 1.0)});
    if (d > 0) jumps.push_back({d, d - 1, 0.5 * double(d)});
  }
  return {row_of(1, species("M", 30) + species("D", 0) + reaction("2 M <-> D", "0.02 m^3/(s molecule)", "0.5 1/s"),
                 "0.4 s", "0.2 s"),
          "D", chain_law(16, jumps, 0, 0.4)};
}

Experiment binding() {
  std::vector<ChainJump> jumps;
  for (std::size_t c = 0; c <= 15; ++c) {
    if (c < 15) jumps.push_back({c, c + 1, 0.1 * (20.0 - double(c)) * (15.0 - double(c))});
    if (c > 0) jumps.push_back({c, c - 1, double(c)});
  }
  return {row_of(1,
                 species("A", 20) + species("B", 15) + species("C", 0) +
                     reaction("A + B <-> C", "0.1 m^3/(s molecule)", "1 1/s"),
                 "0.3 s", "0.1 s"),
          "C", chain_law(16, jumps, 0, 0.3)};
}

// Schloegl's model in our convention: 2 X -> 3 X at k1 n (n - 1), 3 X -> 2 X at k2 n (n - 1)(n - 2), and birth and
// death.
Experiment schloegl() {
  constexpr std::size_t states = 160;
  std::vector<ChainJump> jumps;
  for (std::size_t k = 0; k < states; ++k) {
    const double n = double(k);
    jumps.push_back({k, k + 1, 0.15 * n * (n - 1.0) + 45.0});
    if (k > 0) jumps.push_back({k, k - 1, 0.0015 * n * (n - 1.0) * (n - 2.0) + 5.0 * n});
  }
  return {row_of(1,
                 species("X", 25) + reaction("2 X -> 3 X", "0.15 m^3/(s molecule)") +
                     reaction("3 X -> 2 X", "0.0015 m^6/(s molecule^2)") +
                     reaction("nothing <-> X", "45 molecules/(m^3 s)", "5 1/s"),
                 "1 s", "0.5 s"),
          "X", chain_law(states, jumps, 25, 1.0)};
}

// Forty walkers on ten voxels, all from the left end; whoever reaches the right side is gone. The side is half a voxel
// from the last voxel's middle, so it takes molecules at twice the rate of a jump.
Experiment first_passage() {
  std::vector<ChainJump> jumps;
  for (std::size_t i = 0; i < 10; ++i) {
    if (i > 0) jumps.push_back({i, i - 1, 1.0});
    if (i < 9) jumps.push_back({i, i + 1, 1.0});
  }
  jumps.push_back({9, 10, 2.0});
  const double gone = chain_law(11, jumps, 0, 60.0)[10];
  std::vector<double> law;  // binomial: how many of forty are left
  for (int n = 0; n <= 40; ++n)
    law.push_back(std::exp(std::lgamma(41.0) - std::lgamma(n + 1.0) - std::lgamma(41.0 - n)) * std::pow(1.0 - gone, n) *
                  std::pow(gone, 40 - n));
  return {row_of(10, R"toml([species.X]
diffusivity = "1 m^2/s"
[[initial]]
species = "X"
count = "40 molecules"
shape = "box"
lower = ["0 m"]
upper = ["1 m"]
[[boundary]]
species = "X"
at = "x_max"
type = "absorb"
)toml",
                 "60 s", "5 s"),
          "X", law, 1500};
}

// A + B <-> C with diffusion over four voxels in equilibrium: the total of C has the law of one voxel of their volume
// (product of Poisson laws given A + C and B + C).
Experiment product_form() {
  const double volume = 4.0;
  const auto law = balanced_law(
      41, [&](double c) { return 0.5 / volume * (40.0 - c) * (48.0 - c); }, [](double c) { return 2.0 * c; });
  return {row_of(4,
                 species("A", 10) + species("B", 12) + species("C", 0) +
                     reaction("A + B <-> C", "0.5 m^3/(s molecule)", "2 1/s"),
                 "6 s", "0.02 s"),
          "C", law, 1500};
}

}  // namespace

std::vector<Case> chemistry_cases(std::uint64_t seed) {
  std::vector<Case> cases;
  const auto add = [&](const char* name, const char* what, Experiment (*make)()) {
    cases.push_back({name, what, [make, seed] { return judge(make(), seed); }});
  };
  add("birth-death", "nothing <-> X, on its way to Poisson", birth_and_death);
  add("batches", "nothing -> 5 X -> ..., immigration in batches", batches);
  add("dimers", "2 M <-> D on its way to equilibrium", dimers);
  add("binding", "A + B <-> C on its way to equilibrium", binding);
  add("schloegl", "2 X <-> 3 X, nothing <-> X: broad and of two peaks", schloegl);
  add("first-passage", "walkers that leave at the far end of a row of voxels", first_passage);
  add("product-form", "A + B <-> C with diffusion, in equilibrium", product_form);
  return cases;
}

}  // namespace shmoo::run::verify
