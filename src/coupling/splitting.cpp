#include "coupling/splitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "coupling/splitting_twin.hpp"
#include "rdme/sampler.hpp"
#include "scene/motion.hpp"
#include "scene/surface.hpp"

namespace shmoo::coupling {
namespace {

constexpr double part_of_time_scale = 0.01;  // where no twin can be had
constexpr double time_scales = 10;           // that a twin is followed for
constexpr int fewest = 8, most = 4096;       // steps of a twin

rdme::Treatment treatment(const rdme::Network& network, int species) {
  return network.stochastic(species) ? rdme::Treatment::sampled
         : network.langevin(species) ? rdme::Treatment::langevin
                                     : rdme::Treatment::integrated;
}

// Whether reactions that are treated in different ways touch each other's species.
bool kinds_meet(const rdme::Network& network) {
  for (const auto& reaction : network.reactions()) {
    for (const int s : reaction.reads)
      if (treatment(network, s) != reaction.treatment()) return true;
    for (const auto& change : reaction.changes)
      if (treatment(network, change.species) != reaction.treatment()) return true;
  }
  return false;
}

// Whether any sampled molecule jumps, enters or leaves.
bool anything_moves(const scene::Scene& scene) {
  if (scene::in_motion(scene) || !scene.boundaries.empty() || !scene.inflows.empty()) return true;
  return std::any_of(scene.species.begin(), scene.species.end(), [](const auto& species) {
    return species.method == scene::SpeciesMethod::stochastic && species.diffusivity > 0.0;
  });
}

// Events per volume and time of mass action.
template <class Reaction>
double mass_action(const Reaction& reaction, const std::vector<double>& reference) {
  double v = reaction.rate_constant;
  for (const auto& term : reaction.reactants) v *= std::pow(reference[std::size_t(term.species)], term.count);
  return v;
}

// The largest rate [1/s] at which a reaction renews a species.
std::pair<double, std::string> fastest_reaction(const rdme::Network& network, const std::vector<double>& reference) {
  double fastest = 0.0;
  std::string name;
  for (const auto& reaction : network.reactions()) {
    if (!reaction.expression.empty() || reaction.per_area) continue;
    const double v = mass_action(reaction, reference);
    for (const auto& change : reaction.changes) {
      const double c = reference[std::size_t(change.species)];
      const double rate = c > 0.0 ? std::abs(change.amount) * v / c : 0.0;
      if (rate > fastest) {
        fastest = rate;
        name = reaction.name;
      }
    }
  }
  return {fastest, name};
}

}  // namespace

std::vector<double> reference_concentrations(const scene::Scene& scene, std::vector<double> start) {
  std::vector<double> reference = std::move(start);
  reference.resize(scene.species.size(), 0.0);
  const auto raise = [&](int species, double to) {
    reference[std::size_t(species)] = std::max(reference[std::size_t(species)], to);
  };
  for (const auto& initial : scene.initials) raise(initial.species, initial.concentration.value);
  for (const auto& boundary : scene.boundaries)
    if (boundary.type == scene::BoundaryType::fixed) raise(boundary.species, boundary.value);
  for (const auto& inflow : scene.inflows)
    for (const auto& [species, target] : inflow.species) raise(species, target);
  for (const auto& axis : scene.domain.sides)
    for (const auto& side : axis)
      for (const auto& [species, concentration] : side.species) raise(species, concentration);
  for (const auto& source : scene.mechanics.sources) raise(source.species, source.concentration);
  for (std::size_t round = 0; round < scene.reactions.size(); ++round) {
    for (const auto& reaction : scene.reactions) {
      double least = std::numeric_limits<double>::infinity();
      for (const auto& term : reaction.reactants) least = std::min(least, reference[std::size_t(term.species)]);
      if (reaction.reactants.empty() || !(least > 0.0)) continue;
      for (const auto& term : reaction.products)
        if (reference[std::size_t(term.species)] == 0.0) raise(term.species, least);
    }
  }
  return reference;
}

std::vector<double> turnover(const scene::Scene& scene, const std::vector<double>& reference) {
  std::vector<double> rate(reference.size(), 0.0);
  for (const auto& reaction : scene.reactions) {
    if (!reaction.expression.empty() || scene::on_surface(reaction)) continue;
    for (const auto& term : reaction.reactants) {
      const auto s = std::size_t(term.species);
      if (reference[s] > 0.0) rate[s] += term.count * mass_action(reaction, reference) / reference[s];
    }
  }
  return rate;
}

namespace {

// The longest step whose error is within the tolerance, from an eighth of the horizon on.
Step by_twin(const scene::Scene& scene, SplittingTwin& twin, double horizon) {
  const double tolerance = scene.numerics.splitting_tolerance;
  const double extrapolation = twin.order() == 2 ? 4.0 / 3.0 : 2.0;
  Step found;
  auto coarse = twin.amounts(horizon, fewest);
  for (int steps = fewest; 2 * steps <= most; steps *= 2) {
    const auto fine = twin.amounts(horizon, 2 * steps);
    found = {horizon / steps, {}, 0.0};
    for (std::size_t at = 0; at < fine.size(); ++at)
      found.error = std::max(found.error, extrapolation * std::abs(fine[at] - coarse[at]));
    if (found.error <= tolerance) break;
    coarse = fine;
  }
  found.why = fmt::format(
      "{}a twin of two voxels has an error of {:.2g} of its amounts, of order {} in the step, by halving "
      "it (numerics.splitting_tolerance = {:g})",
      found.error > tolerance ? "WARNING: the shortest that was tried; " : "", found.error, twin.order(), tolerance);
  return found;
}

}  // namespace

Step splitting_step(const scene::Scene& scene, const rdme::Network& network, const std::vector<double>& start) {
  if (scene.numerics.splitting_step) return {*scene.numerics.splitting_step, "as given by numerics.splitting_step"};
  const bool in_turns = rdme::takes_turns(scene.numerics.sampler) && network.any_sampled() && anything_moves(scene);
  if (!in_turns && !kinds_meet(network)) {
    return {std::numeric_limits<double>::infinity(),
            "nothing is split: every process of this scene is advanced as one"};
  }
  const auto reference = reference_concentrations(scene, start);
  const auto [rate, name] = fastest_reaction(network, reference);
  const double fallback = rate > 0.0 ? part_of_time_scale / rate : 0.1 * scene.run.record_every;
  try {
    SplittingTwin twin(scene, network, reference);
    return by_twin(scene, twin, rate > 0.0 ? std::min(scene.run.until, time_scales / rate) : scene.run.record_every);
  } catch (const base::RunError& error) {
    return {fallback, fmt::format("{}, as a twin of two voxels cannot be followed: {}",
                                  rate > 0.0 ? fmt::format("{:g} of the time scale of {}", part_of_time_scale, name)
                                             : "a tenth of run.record_every",
                                  error.what())};
  }
}

}  // namespace shmoo::coupling
