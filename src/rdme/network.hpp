#pragma once
// The reaction network: who takes part, at which propensity, who is treated how, and what an event changes.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shmoo::rdme {

struct Change { int species = 0; int amount = 0; };  // net, never zero

struct Reaction {
  std::string name;
  std::vector<scene::Term> reactants;
  std::vector<Change> changes;
  double rate_constant = 0;        // [(molecules/m^3)^(1-m)/s], v = k prod C^nu
  int expression = -1;             // index of a compiled rate law; -1: mass action
  std::vector<bool> in_material;   // by material: does it run there?
  bool stochastic = false;         // sampled where an event changes a stochastic species; integrated otherwise
};

}  // namespace shmoo::rdme
