#include "run/verify/chemistry/experiment.hpp"

#include <fmt/format.h>

#include <numeric>

#include "run/verify/jump_chain.hpp"
#include "scene/read.hpp"

namespace shmoo::run::verify {
namespace {

double in_first(const coupling::MemorySink& sink, const std::string& species, std::size_t voxels) {
  if (species.empty()) return 0.0;
  const auto& n = sink.at(species, 1);
  return std::accumulate(n.begin(), n.begin() + long(std::min(voxels, n.size())), 0.0);
}

// Twice the chance of a normal number beyond the mean's distance from its law.
double chance_of_mean(const std::vector<double>& numbers, double mean) {
  const double n = double(numbers.size());
  double sum = 0.0, squares = 0.0;
  for (const double x : numbers) {
    sum += x - mean;
    squares += (x - mean) * (x - mean);
  }
  const double variance = (squares - sum * sum / n) / (n - 1.0);
  return std::erfc(std::abs(sum / n) / std::sqrt(2.0 * variance / n));
}

}  // namespace

std::vector<Finding> judge(const Experiment& experiment, std::uint64_t seed) {
  std::vector<Finding> findings;
  for (const auto& sampler : experiment.samplers) {
    const coupling::Laboratory lab(
        scene::read_scene_text(experiment.model, "case.toml",
                               {{"numerics.sampler", "\"" + sampler + "\""}, {"run.seed", std::to_string(seed)}}));
    std::vector<double> numbers;
    double unbalanced = 0.0;
    for (int k = 0; k < experiment.realisations; ++k) {
      coupling::Outcome outcome;
      const auto sink = lab.realise(std::uint32_t(k), &outcome);
      numbers.push_back(in_first(sink, experiment.species, experiment.voxels) -
                        in_first(sink, experiment.minus, experiment.voxels));
      unbalanced += !outcome.balanced;
    }
    const bool whole_law = !experiment.law.empty();
    const double found = whole_law ? chance_of(experiment.law, {numbers.begin(), numbers.end()})
                                   : chance_of_mean(numbers, experiment.mean);
    findings.push_back(
        verify::chance(fmt::format("chance of {} further from the law, {}", whole_law ? "numbers" : "a mean", sampler),
                       found, false_alarm));
    findings.push_back(exactly("ledgers that do not balance, " + sampler, unbalanced, 0.0));
  }
  return findings;
}

std::string row_of(int voxels, const std::string& chemistry, const std::string& until, const std::string& step) {
  return fmt::format(
      "title = \"A row of voxels\"\ndimension = 1\ncross_section = \"1 m^2\"\n[domain]\nsize = [\"{} m\"]\n"
      "spacing = \"1 m\"\nmaterial = \"medium\"\n[materials.medium]\ntype = \"still\"\n{}[numerics]\nreach = "
      "1.2\nsplitting_step = \"{}\"\n"
      "limits = \"warn\"\n[run]\nuntil = \"{}\"\nrecord_every = \"{}\"\n",
      voxels, chemistry, step, until, until);
}

std::string species(const std::string& name, int initial, const std::string& diffusivity) {
  return fmt::format("[species.{}]\ndiffusivity = \"{}\"\ninitial = \"{} molecules/m^3\"\n", name, diffusivity,
                     initial);
}

std::string reaction(const std::string& equation, const std::string& forward, const std::string& backward) {
  const std::string back = backward.empty() ? "" : "backward = \"" + backward + "\"\n";
  return fmt::format("[[reaction]]\nequation = \"{}\"\nforward = \"{}\"\n{}", equation, forward, back);
}

std::string custom_reaction(const std::string& equation, const std::string& rate) {
  return fmt::format("[[reaction]]\nequation = \"{}\"\nrate = \"{}\"\n", equation, rate);
}

std::string start_in(const std::string& species, int count, int from, int to) {
  return fmt::format(
      "[[initial]]\nspecies = \"{}\"\ncount = \"{} molecules\"\nshape = \"box\"\nlower = [\"{} m\"]\nupper = [\"{} "
      "m\"]\n",
      species, count, from, to);
}

std::vector<double> binomial_law(int n, double p) {
  std::vector<double> law;
  for (int k = 0; k <= n; ++k)
    law.push_back(std::exp(std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0)) * std::pow(p, k) *
                  std::pow(1.0 - p, n - k));
  return law;
}

std::vector<double> poisson_law(double mean, int largest) {
  std::vector<double> law;
  for (int k = 0; k <= largest; ++k) law.push_back(std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0)));
  return law;
}

}  // namespace shmoo::run::verify
