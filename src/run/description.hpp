#pragma once
// What a result file says about the experiment itself: all of it known before the first realisation.
#include <string>

#include "coupling/experiment.hpp"

namespace shmoo::run {

struct Description {
  explicit Description(const coupling::Experiment& experiment);

  const scene::Scene& scene;
  std::string hash;  // SHA-256 of the model text
  std::vector<std::int32_t> material;
  std::vector<std::array<double, 3>> start_position;  // [m]
  std::vector<coupling::Experiment::Derived> derived;
};

// What tells equal runs apart; lives under /provenance alone.
struct Provenance {
  std::string host, started, updated;  // ISO 8601, UTC
  int threads = 1;
  double seconds = 0;                      // wall time of this session
  double cpu_seconds_shared = 0;           // of what all realisations share
  double cpu_seconds_per_realisation = 0;  // all threads, mean over those finished in this session
  std::string command;
};

std::string utc_now();
std::string host_name();

// How this program was built.
struct Build {
  std::string version, compiler, flags, architecture, revision;
};
const Build& build();

}  // namespace shmoo::run
