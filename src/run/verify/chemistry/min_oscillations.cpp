// MinD and MinE swing between the ends of a rod-shaped cell (Huang, Meir, Wingreen 2003, PNAS 100, 12724).
#include <algorithm>
#include <numeric>
#include <utility>

#include "run/min_reactions.hpp"
#include "run/verify/chemistry/experiment.hpp"
#include "scene/read.hpp"

namespace shmoo::run::verify {
namespace {

// The cell as a strip 4 um long with membrane on both sides: its volume, pi um^3, and its surface, 4 pi um^2, are those
// of a cylinder of radius 0.5 um.
const std::string strip = R"toml(
title = "Min oscillations on a strip"
dimension = 2
depth = "1.5707963267948966 um"
[domain]
size = ["4 um", "1.5 um"]
spacing = "0.5 um"
material = "membrane"
[materials.cytoplasm]
type = "still"
[materials.membrane]
type = "still"
[[region]]
material = "cytoplasm"
shape = "box"
lower = ["0 um", "0.5 um"]
upper = ["4 um", "1 um"]
[species]
D_ADP = { in = "cytoplasm", diffusivity = "2.5 um^2/s" }
D_ATP = { in = "cytoplasm", diffusivity = "2.5 um^2/s" }
E = { in = "cytoplasm", diffusivity = "2.5 um^2/s" }
d = { in = "membrane" }
de = { in = "membrane" }
[[initial]]
species = "D_ATP"
count = "4000 molecules"
shape = "box"
lower = ["0 um", "0 um"]
upper = ["2 um", "1.5 um"]
[[initial]]
species = "E"
count = "1400 molecules"
[numerics]
reach = 1.2
limits = "warn"
[run]
until = "360 s"
record_every = "1 s"
)toml";

// Mean time between swings to the left, once the start is forgotten; a swing goes through a quarter of the largest
// difference on either side.
double period(const std::vector<double>& difference, std::size_t from) {
  double largest = 0.0;
  for (std::size_t k = from; k < difference.size(); ++k) largest = std::max(largest, std::abs(difference[k]));
  std::vector<std::size_t> swings;
  bool right = false;
  for (std::size_t k = from; k < difference.size(); ++k) {
    if (difference[k] < -0.25 * largest) right = true;
    if (difference[k] > 0.25 * largest && std::exchange(right, false)) swings.push_back(k);
  }
  return swings.size() < 2 ? 0.0 : double(swings.back() - swings.front()) / double(swings.size() - 1);
}

struct Swing {
  double period = 0, d_lost = 0, e_lost = 0;
};

Swing swing_of(const coupling::Laboratory& lab, const coupling::MemorySink& sink) {
  const auto place = lab.experiment->start_position();
  Swing swing;
  std::vector<double> difference;
  for (std::size_t time = 0; time < lab.experiment->layout().times.size(); ++time) {
    const auto total = [&](const char* species) {
      const auto& n = sink.at(species, time);
      return std::accumulate(n.begin(), n.end(), 0.0);
    };
    swing.d_lost =
        std::max(swing.d_lost, std::abs(total("D_ADP") + total("D_ATP") + total("d") + total("de") - 4000.0));
    swing.e_lost = std::max(swing.e_lost, std::abs(total("E") + total("de") - 1400.0));
    double left = 0.0;
    for (std::size_t i = 0; i < place.size(); ++i)
      left += (place[i][0] < 2e-6 ? 1.0 : -1.0) * (sink.at("d", time)[i] + sink.at("de", time)[i]);
    difference.push_back(left);
  }
  swing.period = period(difference, 60);
  return swing;
}

}  // namespace

// The lattice is coarse, so the period is that of its own deterministic equations, near the cell's 41 s.
std::vector<Finding> min_oscillations(std::uint64_t seed) {
  const coupling::Laboratory mean(
      scene::read_scene_text(strip + min_reactions, "case.toml", {{"numerics.method", "\"deterministic\""}}));
  const Swing smooth = swing_of(mean, mean.shared);
  std::vector<Finding> findings{
      within("period [s], deterministic", smooth.period, 35.0, 47.0),
      at_most("molecules lost or gained, deterministic", smooth.d_lost + smooth.e_lost, 1e-4)};
  for (const std::string sampler : {"direct", "composition_rejection"}) {
    const coupling::Laboratory lab(
        scene::read_scene_text(strip + min_reactions, "case.toml",
                               {{"numerics.sampler", "\"" + sampler + "\""}, {"run.seed", std::to_string(seed)}}));
    coupling::Outcome outcome;
    const auto sink = lab.realise(0, &outcome);
    const Swing swing = swing_of(lab, sink);
    findings.push_back(within("period [s], " + sampler, swing.period, smooth.period - 3.0, smooth.period + 3.0));
    findings.push_back(exactly("molecules lost or gained, " + sampler, swing.d_lost + swing.e_lost, 0.0));
    findings.push_back(exactly("ledgers that do not balance, " + sampler, outcome.balanced ? 0.0 : 1.0, 0.0));
  }
  return findings;
}

}  // namespace shmoo::run::verify
