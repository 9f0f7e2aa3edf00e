#include <gsl/gsl_cdf.h>

#include <numeric>

#include "coupling/laboratory.hpp"
#include "run/verify/case.hpp"
#include "scene/read.hpp"

namespace shmoo::run::verify {
namespace {

using coupling::Laboratory;

Laboratory laboratory(const std::string& text, const scene::Overrides& overrides = {}) {
  return Laboratory(scene::read_scene_text(text, "case.toml", overrides));
}

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

std::string line_of(int voxels, const std::string& chemistry, const std::string& until) {
  return "title = \"A closed line of voxels\"\ndimension = 1\ncross_section = \"1 m^2\"\n[domain]\nsize = [\"" +
         std::to_string(voxels) + " m\"]\nspacing = \"1 m\"\n[materials.medium]\ntype = \"still\"\n" + chemistry +
         "[numerics]\nreach = 1.2\n[run]\nuntil = \"" + until + "\"\nrecord_every = \"" + until + "\"\n";
}

// A single voxel has no neighbour: birth and death there is the well-mixed law, Poisson with mean k/d = 20.
std::vector<Finding> one_voxel() {
  const auto lab = laboratory(line_of(1, R"toml([species.X]
diffusivity = "1 m^2/s"
[[reaction]]
equation = "nothing <-> X"
forward = "20 molecules/(m^3 s)"
backward = "1 1/s"
)toml",
                                      "20 s"));
  constexpr int realisations = 4000;
  double s = 0.0, s2 = 0.0;
  for (int k = 0; k < realisations; ++k) {
    const double n = sum(lab.realise(std::uint32_t(k)).at("X", 1));
    s += n;
    s2 += n * n;
  }
  const double mean = s / realisations, variance = s2 / realisations - mean * mean;
  return {standard_errors("mean against 20", (mean - 20.0) / std::sqrt(20.0 / realisations)),
          // Variance of a sample variance of Poisson numbers: (mu4 - sigma^4)/n, mu4 = 3 mu^2 + mu.
          standard_errors("variance against 20", (variance - 20.0) / std::sqrt((2 * 400.0 + 20.0) / realisations))};
}

// One molecule jumps for ever, is always one, and is everywhere equally often.
std::vector<Finding> one_molecule() {
  constexpr int voxels = 10, realisations = 3000;
  const auto lab = laboratory(line_of(voxels, R"toml([species.X]
diffusivity = "1 m^2/s"
[[initial]]
species = "X"
count = "1 molecules"
)toml",
                                      "1000 s"));
  std::vector<double> visits(voxels, 0.0);
  double wrong = 0.0;
  for (int k = 0; k < realisations; ++k) {
    const auto sink = lab.realise(std::uint32_t(k));
    const auto& n = sink.at("X", 1);
    wrong += sum(n) != 1.0;
    for (int i = 0; i < voxels; ++i) visits[std::size_t(i)] += n[std::size_t(i)];
  }
  const double expected = double(realisations) / voxels;
  double chi2 = 0.0;
  for (const double v : visits) chi2 += (v - expected) * (v - expected) / expected;
  return {exactly("realisations in which it is not one molecule", wrong, 0.0),
          at_least("probability of a less even spread over the voxels", gsl_cdf_chisq_Q(chi2, voxels - 1), 1e-6)};
}

// 10^9 molecules in 100 voxels diffuse: none is lost, and numbers stay multinomial.
std::vector<Finding> a_billion_molecules() {
  constexpr int voxels = 100, realisations = 40;
  const auto lab = laboratory(line_of(voxels, R"toml([species.X]
diffusivity = "1 m^2/s"
[[initial]]
species = "X"
count = "1e9 molecules"
)toml",
                                      "2 s"),
                              {{"numerics.sampler", "\"split\""}, {"numerics.splitting_step", "\"0.5 s\""}});
  double lost = 0.0, chi2 = 0.0;
  const double mean = 1e9 / voxels;
  for (int k = 0; k < realisations; ++k) {
    const auto sink = lab.realise(std::uint32_t(k));
    lost += std::abs(sum(sink.at("X", 1)) - 1e9);
    for (const double n : sink.at("X", 1)) chi2 += (n - mean) * (n - mean) / mean;
  }
  // Spread over all voxels at random from the start, as counts are: multinomial then and ever after.
  const double degrees = double(realisations) * (voxels - 1);
  return {exactly("molecules lost or gained", lost, 0.0),
          standard_errors("variance of a voxel against the multinomial", (chi2 - degrees) / std::sqrt(2.0 * degrees))};
}

// Everything dies out, also by a rate that is no polynomial; then nothing is left to happen and time must go on.
std::vector<Finding> extinction(const std::string& sampler) {
  const auto lab = laboratory(line_of(20, R"toml([parameters]
V = "3 molecules/(m^3 s)"
K = "2 molecules/m^3"
[species.A]
diffusivity = "1 m^2/s"
initial = "50 molecules/m^3"
[species.B]
diffusivity = "0 m^2/s"
initial = "5 molecules/m^3"
[species.C]
initial = "0 molecules/m^3"
diffusivity = "1 m^2/s"
[[reaction]]
equation = "A + A -> nothing"
forward = "0.05 m^3/(s molecule)"
[[reaction]]
equation = "A -> nothing"
forward = "0.2 1/s"
[[reaction]]
equation = "B -> nothing"
rate = "V * B^2 / (K^2 + B^2)"
[[reaction]]
equation = "C -> A"
forward = "1 1/s"
[[reaction]]
equation = "A -> B"
forward = "0 1/s"
)toml",
                                      "1e6 s"),
                              {{"numerics.sampler", "\"" + sampler + "\""}, {"numerics.splitting_step", "\"100 s\""}});
  double left = 0.0, unbalanced = 0.0;
  for (std::uint32_t k = 0; k < 20; ++k) {
    coupling::Outcome outcome;
    const auto sink = lab.realise(k, &outcome);
    for (const char* species : {"A", "B", "C"}) left += sum(sink.at(species, 1));
    unbalanced += !outcome.balanced;
  }
  return {exactly("molecules left", left, 0.0), exactly("ledgers that do not balance", unbalanced, 0.0)};
}

std::vector<Finding> extinction() {
  auto all = extinction("composition_rejection");
  for (const char* sampler : {"direct", "split"}) {
    for (auto& finding : extinction(sampler)) {
      finding.law += std::string(", ") + sampler;
      all.push_back(std::move(finding));
    }
  }
  return all;
}

}  // namespace

std::vector<Case> hard_chemistry() {
  return {{"one-voxel", "a domain of one voxel", one_voxel},
          {"one-molecule", "a single molecule over a long time", one_molecule},
          {"billion-molecules", "10^9 molecules", a_billion_molecules},
          {"extinction", "propensities that vanish, one after the other", [] { return extinction(); }}};
}

}  // namespace shmoo::run::verify
