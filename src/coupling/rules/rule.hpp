#pragma once
// A rule decides one key of a model that is left to "auto": it looks at one number of the scene and says why.
#include <span>
#include <string>

#include "coupling/rules/numbers.hpp"

namespace shmoo::coupling {

struct Verdict {
  bool on = false;
  double value = nothing_known;  // the number that the rule looked at
  std::string reason;
  std::string warning{};  // what may still be wrong with it, and what to do; empty: nothing
};

struct EffectRule {
  const char* effect;  // its key in [effects]
  const char* number;  // what the rule looks at
  double threshold;
  const char* source;
  Verdict (*judge)(const scene::Scene& scene, const Numbers& numbers, double threshold);
  const char* without;  // what is neglected where the effect is off
};

// In the order in which they are decided: the numbers of a later rule may depend on an earlier verdict.
std::span<const EffectRule> effect_rules();

// How a species is treated: counted, as a smooth amount with noise, or as a smooth concentration. The first rule whose
// condition holds decides.
struct MethodRule {
  const char* number;
  double threshold;
  const char* source;
  double (*value)(const SpeciesNumbers& species);
  bool (*holds)(double value, double threshold);
  scene::SpeciesMethod method;  // what it decides
  const char* reason;           // a format of value and threshold
};

std::span<const MethodRule> method_rules();

// By whom a decision was made, and which.
struct Decision {
  std::string key;         // "effects.viscosity", "species.L.method"
  std::string value{};     // "on", "off", "stochastic", "langevin", "deterministic", "split"
  bool automatic = false;  // by rule; else by the model file or its defaults
  std::string by_rule{};   // what the rule says, where the file says otherwise
  double number = nothing_known;
  std::string looked_at{};
  double threshold = nothing_known;
  std::string source{}, reason{}, warning{}, without{};
};

// Which sampler draws the events; decides it where the scene leaves it open.
Decision judge_sampler(scene::Scene& scene, const Numbers& numbers);

}  // namespace shmoo::coupling
