#include "coupling/rules/decide.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/well.hpp"

namespace shmoo::coupling {
namespace {

using scene::SpeciesMethod;

using Member = bool scene::Effects::*;

Member member_of(const char* effect) {
  for (const auto& [name, on] : scene::effect_keys)
    if (std::string_view(name) == effect) return on;
  throw std::logic_error(fmt::format("no effect is called {}", effect));
}

const char* word(bool on) { return on ? "on" : "off"; }
const char* word(SpeciesMethod method) {
  return method == SpeciesMethod::stochastic ? "stochastic"
         : method == SpeciesMethod::langevin ? "langevin"
                                             : "deterministic";
}

Decision judge_effect(const EffectRule& rule, scene::Scene& scene, const Numbers& numbers) {
  const Member member = member_of(rule.effect);
  bool& on = scene.effects.*member;
  const auto verdict = rule.judge(scene, numbers, rule.threshold);
  Decision decision{.key = fmt::format("effects.{}", rule.effect),
                    .automatic = std::count(scene.undecided.begin(), scene.undecided.end(), member) > 0,
                    .number = verdict.value,
                    .looked_at = rule.number,
                    .threshold = rule.threshold,
                    .source = rule.source,
                    .reason = verdict.reason,
                    .warning = verdict.warning,
                    .without = rule.without};
  if (decision.automatic)
    on = verdict.on;
  else if (on != verdict.on)
    decision.by_rule = word(verdict.on);
  decision.value = word(on);
  return decision;
}

// A flow that a rule switches off takes its effects with it.
void follow_the_flow(scene::Scene& scene) {
  if (scene.effects.flow) return;
  for (const auto& [name, on] : scene::effect_keys) scene.effects.*on = false;
}

Decision judge_species(scene::Species& species, const SpeciesNumbers& numbers) {
  Decision decision{.key = fmt::format("species.{}.method", species.name)};
  decision.automatic = species.method == SpeciesMethod::automatic;
  for (const MethodRule& rule : method_rules()) {
    const double value = rule.value(numbers);
    if (!rule.holds(value, rule.threshold)) continue;
    const auto method = rule.method;
    if (decision.automatic)
      species.method = method;
    else if (method != species.method)
      decision.by_rule = word(method);
    decision.number = value;
    decision.looked_at = rule.number;
    decision.threshold = rule.threshold;
    decision.source = rule.source;
    decision.reason = fmt::format(fmt::runtime(rule.reason), value);
    break;
  }
  decision.value = word(species.method);
  return decision;
}

}  // namespace

bool undecided(const scene::Scene& scene) {
  const auto open = [](const scene::Species& species) { return species.method == SpeciesMethod::automatic; };
  return !scene.undecided.empty() || scene.numerics.sampler == scene::Sampler::automatic ||
         std::any_of(scene.species.begin(), scene.species.end(), open);
}

Decided decide(scene::Scene scene) {
  Decided decided{.scene = std::move(scene)};
  auto& ours = decided.scene;
  decided.numbers = numbers_of(ours);
  for (const EffectRule& rule : effect_rules()) {
    if (scene::well_mixed(ours)) break;  // nothing flows
    const auto before = ours.effects.*member_of(rule.effect);
    decided.decisions.push_back(judge_effect(rule, ours, decided.numbers));
    follow_the_flow(ours);
    if (ours.effects.*member_of(rule.effect) != before) decided.numbers = numbers_of(ours);
  }
  ours.undecided.clear();
  for (std::size_t s = 0; s < ours.species.size(); ++s)
    decided.decisions.push_back(judge_species(ours.species[s], decided.numbers.species[s]));
  const auto sampled = [](const auto& species) { return species.method == SpeciesMethod::stochastic; };
  if (ours.numerics.sampler == scene::Sampler::automatic ||
      std::any_of(ours.species.begin(), ours.species.end(), sampled))
    decided.decisions.push_back(judge_sampler(ours, decided.numbers));
  return decided;
}

std::string line(const Decision& decision) {
  auto text = fmt::format("{} = {} (auto: {})", decision.key, decision.value, decision.reason);
  if (!decision.warning.empty()) text += "; WARNING: " + decision.warning;
  return text;
}

}  // namespace shmoo::coupling
