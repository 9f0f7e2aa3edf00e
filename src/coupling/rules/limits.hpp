#pragma once
// Limits that are looked at before anything runs: each number of a scene is well, doubtful or makes the run worthless.
#include <limits>
#include <string>
#include <vector>

#include "coupling/rules/numbers.hpp"

namespace shmoo::coupling {

enum class Standing { ok, warn, refuse };

struct Limit {
  std::string name;
  double value = 0;
  double ok = 0;                                            // well up to here ...
  double refuse = std::numeric_limits<double>::infinity();  // ... worthless beyond here
  std::string meaning;                                      // what the value is, with its arithmetic
  std::string suggestion;                                   // what to do where it is not well
  std::string source;

  // Round-off must not decide where a derived number meets its own limit.
  Standing standing() const {
    constexpr double slack = 1.0 + 1e-9;
    return value <= ok * slack ? Standing::ok : value <= refuse * slack ? Standing::warn : Standing::refuse;
  }
};

const char* word(Standing standing);

// How fast this machine works: as a guess that no machine of today beats by far, or as measured.
struct Pace {
  double particle_steps = 2e7;  // of the flow [1/s]
  double events = 5e7;          // of exact samplers [1/s]
  bool measured = false;
};

// Every limit that concerns the scene, which must be decided.
std::vector<Limit> judge_limits(const scene::Scene& scene, const Numbers& numbers, const Pace& pace = {});

// Parts of it.
void judge_flow_limits(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits);
void judge_chemistry_limits(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits);
void judge_run_limits(const scene::Scene& scene, const Numbers& numbers, const Pace& pace, std::vector<Limit>& limits);

// Throws base::InputError where one of them refuses, unless numerics.limits is "warn".
void enforce(const scene::Scene& scene, const std::vector<Limit>& limits);

// How many particles a fluid particle at a wall sees in a row through the thinnest place of any wall of the scene;
// infinite where no fluid touches a wall.
double thinnest_wall(const scene::Scene& scene);

// [m] The least diameter of the revolved outlines in which fluid may flow; infinite without any.
double narrowest_bore(const scene::Scene& scene);

}  // namespace shmoo::coupling
