#pragma once
// What rules and limits say of a scene before its experiment is made.
#include <string>
#include <vector>

#include "coupling/experiment.hpp"

namespace shmoo::coupling {

struct Judgement {
  scene::Scene scene;                          // decided
  std::vector<Experiment::Derived> derived{};  // for the result file: what rules decided, and limits that are not kept
  std::vector<std::string> notes{};            // the same for people
  std::vector<double> reference{};             // [molecules/m^3] by species: the largest that the scene tells of
};

// Throws base::InputError where a limit refuses the scene.
Judgement judge(scene::Scene scene);

}  // namespace shmoo::coupling
