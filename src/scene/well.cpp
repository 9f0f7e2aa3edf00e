#include "scene/well.hpp"

#include <cmath>

#include "scene/formula.hpp"

namespace shmoo::scene {
namespace {

double volume_of(const Scene& scene, int species) {
  return scene.compartments[static_cast<std::size_t>(scene.species[static_cast<std::size_t>(species)].compartment)]
      .volume;
}

std::string times(double factor, const Formula& formula) { return write(call("*", {number(factor), formula})); }

void count(const Scene& scene, Reaction& reaction) {
  if (!reaction.per_volume) return;
  const double volume = volume_of(scene, reaction).value();
  int order = 0;
  for (const Term& term : reaction.reactants) order += term.count;
  reaction.per_volume = false;
  reaction.rate_constant *= std::pow(volume, 1 - order);
  if (reaction.expression.empty()) return;
  std::map<std::string, Formula> concentrations;
  for (std::size_t s = 0; s < scene.species.size(); ++s)
    concentrations[scene.species[s].name] =
        call("/", {name(scene.species[s].name), number(volume_of(scene, static_cast<int>(s)))});
  reaction.expression = times(volume, replace(parse_formula(reaction.expression), concentrations));
}

}  // namespace

std::optional<double> volume_of(const Scene& scene, const Reaction& reaction) {
  const auto& terms = reaction.reactants.empty() ? reaction.products : reaction.reactants;
  int compartment = -1;
  for (const Term& term : terms) {
    const int home = scene.species[static_cast<std::size_t>(term.species)].compartment;
    if (compartment >= 0 && home != compartment) return std::nullopt;
    compartment = home;
  }
  if (compartment < 0) return std::nullopt;
  return scene.compartments[static_cast<std::size_t>(compartment)].volume;
}

Scene in_numbers(Scene scene) {
  for (Reaction& reaction : scene.reactions) count(scene, reaction);
  for (Initial& initial : scene.initials) {
    auto& [value, expression] = initial.concentration;
    const double volume = volume_of(scene, initial.species);
    value *= volume;
    if (!expression.empty()) expression = times(volume, parse_formula(expression));
  }
  for (Compartment& compartment : scene.compartments) compartment.volume = 1;
  return scene;
}

}  // namespace shmoo::scene
