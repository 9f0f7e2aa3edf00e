#include "coupling/splitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rdme/sampler.hpp"
#include "scene/surface.hpp"

namespace shmoo::coupling {
namespace {

constexpr double part_of_time_scale = 0.01;

// Whether an integrated reaction and a sampled one touch each other's species.
bool kinds_meet(const rdme::Network& network) {
  for (const auto& reaction : network.reactions()) {
    for (const int s : reaction.reads)
      if (network.stochastic(s) != reaction.stochastic) return true;
    for (const auto& change : reaction.changes)
      if (network.stochastic(change.species) != reaction.stochastic) return true;
  }
  return false;
}

// Whether any sampled molecule jumps, enters or leaves.
bool anything_moves(const scene::Scene& scene) {
  if (scene.effects.flow || !scene.boundaries.empty() || !scene.inflows.empty()) return true;
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

// The largest rate [1/s] at which a reaction uses up one of its reactants.
std::pair<double, std::string> fastest_reaction(const rdme::Network& network, const std::vector<double>& reference) {
  double fastest = 0.0;
  std::string name;
  for (const auto& reaction : network.reactions()) {
    if (!reaction.expression.empty() || reaction.per_area) continue;
    const double v = mass_action(reaction, reference);
    for (const auto& term : reaction.reactants) {
      const double c = reference[std::size_t(term.species)];
      const double rate = c > 0.0 ? term.count * v / c : 0.0;
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

Step splitting_step(const scene::Scene& scene, const rdme::Network& network) {
  if (scene.numerics.splitting_step) return {*scene.numerics.splitting_step, "as given by numerics.splitting_step"};
  const bool in_turns = rdme::takes_turns(scene.numerics.sampler) && network.any_sampled() && anything_moves(scene);
  if (!in_turns && !kinds_meet(network)) {
    return {std::numeric_limits<double>::infinity(),
            "nothing is split: every process of this scene is advanced as one"};
  }
  const auto [rate, name] = fastest_reaction(network, reference_concentrations(scene));
  if (rate == 0.0)
    return {0.1 * scene.run.record_every, "a tenth of run.record_every, as no rate constant tells a time scale"};
  const double step = part_of_time_scale / rate;
  return {step, fmt::format("{:g} of the time scale of the fastest reaction, {}", part_of_time_scale, name)};
}

}  // namespace shmoo::coupling
