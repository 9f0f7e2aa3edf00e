#pragma once
// What a step of the flow costs, and what of it each present effect is responsible for: measured by running the scene's
// flow for some steps with and without it.
#include <optional>
#include <string>
#include <vector>

#include "coupling/friction_course.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

struct EffectCost {
  std::string name;
  double seconds = 0;                  // CPU time of a step that vanishes without it
  double share = 0;                    // of a step's CPU time
  std::size_t bytes = 0;               // of columns that exist only for it
  std::vector<std::string> columns{};  // their names
  double step_limit = 0;               // [s] that it imposes; infinite: none
  double step_without = 0;             // [s] the time step without it
};

struct FlowCosts {
  std::size_t particles = 0;
  double step = 0;             // [s] the time step
  double step_seconds = 0;     // CPU time of a step on one thread that lists no pairs anew
  double build_seconds = 0;    // CPU time of listing the pairs
  double builds_per_step = 0;  // at the reference speed
  double speedup = 1;          // wall time on one thread over that on all threads
  std::size_t column_bytes = 0, row_bytes = 0;
  std::optional<FrictionCourse> friction{};  // where it is implicit and the flow starts at rest; part of a step
  std::vector<EffectCost> effects{};  // the present ones, as they stand in the list of effects
};

// The scene must be decided and have a flow. Takes about `budget` seconds of CPU time on one thread; `threads` are
// those that a run would have.
FlowCosts measure_flow(const scene::Scene& scene, int threads, double budget);

}  // namespace shmoo::coupling
