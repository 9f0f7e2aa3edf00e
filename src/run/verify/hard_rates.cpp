// Rates and numbers of molecules at their extremes, by every sampler.
#include <cmath>
#include <numeric>

#include "base/error.hpp"
#include "run/verify/chemistry/experiment.hpp"
#include "scene/read.hpp"

namespace shmoo::run::verify {
namespace {

using coupling::Laboratory;

const std::vector<std::string> samplers{"direct", "composition_rejection", "split"};

Laboratory laboratory(const std::string& model, const std::string& sampler, const scene::Overrides& more = {}) {
  scene::Overrides overrides{{"numerics.sampler", "\"" + sampler + "\""}};
  overrides.insert(overrides.end(), more.begin(), more.end());
  return Laboratory(scene::read_scene_text(model, "case.toml", overrides));
}

double total(const coupling::MemorySink& sink, const std::string& species, std::size_t time = 1) {
  const auto& n = sink.at(species, time);
  return std::accumulate(n.begin(), n.end(), 0.0);
}

// No molecules, no reactions that can run, rates of zero, a partner that never comes.
std::vector<Finding> nothing_happens() {
  const std::string idle = row_of(
      5,
      species("None", 0) + species("Still", 7, "0 m^2/s") + species("Partner", 0) + reaction("Still -> None", "0 1/s") +
          reaction("Still + Partner -> None", "1e6 m^3/(s molecule)") + reaction("None -> Partner", "1e6 1/s"),
      "1e6 s", "1e5 s");
  const std::string empty = row_of(3, species("Still", 7, "0 m^2/s"), "1e6 s", "1e5 s");
  std::vector<Finding> findings;
  for (const auto& sampler : samplers) {
    coupling::Outcome outcome;
    const auto sink = laboratory(idle, sampler).realise(0, &outcome);
    findings.push_back(exactly("molecules, " + sampler, total(sink, "Still"), 35.0));
    findings.push_back(exactly("events, " + sampler, double(outcome.reaction_events + outcome.jump_events), 0.0));
    findings.push_back(exactly("molecules of an empty network, " + sampler,
                               total(laboratory(empty, sampler).realise(0), "Still"), 21.0));
  }
  return findings;
}

// A <-> B at a million a second beside B -> C at a millionth: A is binomial from the start on, and C stays nothing.
std::vector<Finding> twelve_decades() {
  const std::string model =
      row_of(20,
             species("A", 10, "0 m^2/s") + species("B", 0, "0 m^2/s") + species("C", 0, "0 m^2/s") +
                 reaction("A <-> B", "1e6 1/s", "1e6 1/s") + reaction("B -> C", "1e-6 1/s"),
             "1 ms", "1 ms");
  std::vector<Finding> findings;
  for (const auto& sampler : samplers) {
    const auto lab = laboratory(model, sampler);
    double a = 0.0, c = 0.0;
    constexpr int realisations = 20, molecules = 200;
    for (std::uint32_t k = 0; k < realisations; ++k) {
      const auto sink = lab.realise(k);
      a += total(sink, "A");
      c += total(sink, "C");
    }
    const double n = double(realisations) * molecules;
    findings.push_back(standard_errors("fast pair in equilibrium, " + sampler, (a - 0.5 * n) / std::sqrt(0.25 * n)));
    findings.push_back(exactly("slow products, " + sampler, c, 0.0));
  }
  return findings;
}

// 10^15 molecules that turn over one in 10^15 seconds each, beside a single one that walks.
std::vector<Finding> huge_and_single() {
  const std::string model = row_of(4,
                                   species("A", 0, "0 m^2/s") + species("B", 0, "0 m^2/s") + species("X", 0) +
                                       "[[initial]]\nspecies = \"A\"\nconcentration = \"1e15 molecules/m^3\"\n" +
                                       start_in("X", 1, 0, 1) + reaction("A -> B", "1e-15 1/s"),
                                   "25 s", "5 s");
  std::vector<Finding> findings;
  for (const auto& sampler : samplers) {
    const auto lab = laboratory(model, sampler);
    double b = 0.0, lost = 0.0;
    constexpr int realisations = 100;
    for (std::uint32_t k = 0; k < realisations; ++k) {
      const auto sink = lab.realise(k);
      b += total(sink, "B");
      lost += std::abs(total(sink, "A") + total(sink, "B") - 4e15) + std::abs(total(sink, "X") - 1.0);
    }
    const double mean = 100.0 * realisations;
    findings.push_back(standard_errors("products, " + sampler, (b - mean) / std::sqrt(mean)));
    findings.push_back(exactly("molecules lost or gained, " + sampler, lost, 0.0));
  }
  return findings;
}

// Rates that turn negative once the run is under way: the run must stop and say which, where and when.
std::vector<Finding> invalid_in_mid_run() {
  const std::string parameters =
      "[parameters]\nk = \"1 molecule/(m^3 s)\"\nend = \"1 s\"\ntop = \"12 molecules/m^3\"\n";
  const std::string late =
      row_of(2, parameters + species("X", 0) + custom_reaction("nothing -> X", "k*(1 - t/end)"), "3 s", "0.5 s");
  const std::string full =
      row_of(2, parameters + species("X", 9) + custom_reaction("nothing -> 5 X", "k*(1 - X/top)"), "300 s", "1 s");
  std::vector<Finding> findings;
  for (const auto& [what, model] : {std::pair{"in time", late}, std::pair{"in numbers", full}}) {
    for (const auto& sampler : samplers) {
      double told = 0.0;
      try {
        laboratory(model, sampler).realise(0);
      } catch (const base::RunError& error) {
        const std::string said = error.what();
        told = 1.0;
        for (const char* part : {"reaction nothing -> ", "voxel", "t = "})
          if (said.find(part) == std::string::npos) told = 0.0;
      }
      findings.push_back(
          exactly(std::string("invalid ") + what + ": refused with reaction, place and time, " + sampler, told, 1.0));
    }
  }
  return findings;
}

// Births begin just after a record and end just after the next: the first must show none of them, the second all.
std::vector<Finding> at_an_output_time() {
  const std::string model = row_of(
      1,
      "[parameters]\nk = \"10000 molecules/(m^3 s)\"\nnone = \"0 molecules/(m^3 s)\"\non = \"1 s\"\noff = \"2 s\"\n" +
          species("X", 0) + custom_reaction("nothing -> X", "t > on && t <= off ? k : none"),
      "3 s", "3 s");
  std::vector<Finding> findings;
  for (const auto& sampler : samplers) {
    const auto sink = laboratory(model, sampler, {{"run.record_every", "\"1 s\""}}).realise(0);
    findings.push_back(exactly("births before the record, " + sampler, total(sink, "X", 1), 0.0));
    findings.push_back(standard_errors("births until the next, " + sampler, (total(sink, "X", 2) - 1e4) / 100.0));
    findings.push_back(exactly("births after it, " + sampler, total(sink, "X", 3) - total(sink, "X", 2), 0.0));
  }
  return findings;
}

}  // namespace

std::vector<Case> hard_rates() {
  return {{"nothing-happens", "no molecules, no reactions, rates of zero, partners that never come", nothing_happens},
          {"twelve-decades", "rates over twelve decades", twelve_decades},
          {"huge-and-single", "10^15 molecules beside a single one", huge_and_single},
          {"invalid-rate", "rates that become invalid in mid-run", invalid_in_mid_run},
          {"output-time", "rates that switch exactly at output times", at_an_output_time}};
}

}  // namespace shmoo::run::verify
