#pragma once
// Steps, memory and time that a run will take: measured rates, extrapolated.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "run/explain/rehearsal.hpp"

namespace shmoo::run {

// What a process holds and has spent when it has read its model and computed nothing.
struct Idle {
  std::size_t heap_bytes = 0;  // allocated
  double seconds = 0;          // CPU time
};

struct Forecast {
  double flow_time = 0;            // [s] simulated with the flow computed
  double flow_steps = 0;           // time steps of the flow, of one run of it
  bool steady = false;             // the flow is expected to become steady then, and to be carried from there
  double start_seconds = 0;        // CPU time of starting the program and reading the model
  double shared_seconds = 0;       // CPU time of what all realisations share
  double once_seconds = 0;         // CPU time of listing jumps, which the first realisation pays for all
  double realisation_seconds = 0;  // CPU time of one realisation
  double cpu_seconds = 0;          // of the whole run
  double wall_seconds = 0;         // of the whole run, on that many threads
  int threads = 1;
  std::size_t bytes = 0;                                      // the most that the run holds in memory
  std::vector<std::pair<std::string, std::size_t>> memory{};  // its parts
  std::string how{};                                          // what was measured
};

// The scene must be decided, and `layout` its own.
Forecast make_forecast(const scene::Scene& scene, const coupling::Numbers& numbers,
                       const std::optional<coupling::FlowCosts>& flow, const Maker& make,
                       const coupling::RecordLayout& layout, int threads, const Idle& idle, double budget);

// CPU time of a whole realisation from its first part, and what of that part only the first realisation pays: listing
// the jumps of moving and of standing voxels. The pace may change linearly until the fraction `until_even`.
struct Course {
  double each = 0, moving_once = 0, standing_once = 0;  // [s]
};
Course extrapolate(const Rehearsal& rehearsal, double until_even);

}  // namespace shmoo::run
