#pragma once
// Decides what a scene leaves to "auto".
#include <vector>

#include "coupling/rules/rule.hpp"

namespace shmoo::coupling {

struct Decided {
  scene::Scene scene;                 // nothing is undecided any more
  std::vector<Decision> decisions{};  // of every effect and species, by rule or by hand
  Numbers numbers{};                  // of the decided scene
};

// Throws base::InputError where the scene cannot be built.
Decided decide(scene::Scene scene);

// True where some key of the scene waits for a decision.
bool undecided(const scene::Scene& scene);

// What a rule decided: "effects.thermal_noise = off (auto: ...)".
std::string line(const Decision& decision);

}  // namespace shmoo::coupling
