#pragma once
// A part of a run, played in full to see what it costs.
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "coupling/experiment.hpp"
#include "coupling/flow_costs.hpp"
#include "coupling/rules/numbers.hpp"

namespace shmoo::run {

// What is played.
struct Play {
  enum class Kind {
    whole,      // the scene as it is, from its beginning
    carried,    // the chemistry on a flow that is steady from the start, at a uniform velocity
    shortened,  // the scene as it is, with an earlier end
  };
  Kind kind = Kind::whole;
  scene::Scene scene;
};

Play choose_play(const scene::Scene& scene, const coupling::Numbers& numbers, const coupling::FlowCosts* flow,
                 double budget);

struct Moment {
  double fraction = 0;  // of the time played
  double seconds = 0;   // CPU time since the beginning
};

struct Rehearsal {
  double prepare_seconds = 0;       // CPU time of what realisations share
  bool prepared = false;            // else stopped
  std::vector<Moment> preparing{};  // of what realisations share, after every interval
  std::vector<Moment> coarse{};     // the same of a coarse wall to the end, where that tells more
  std::vector<Moment> realised{};   // of realisation 0, after every interval
  double closing_seconds = 0;       // CPU time after the last of them
  bool finished = false;
  std::vector<double> activity{};                   // [1/s] in equal parts of the time played; empty: not foretold
  std::vector<double> others{};                     // CPU time of further realisations, where the first was short
  double making_bytes = 0;                          // at most, while the experiment was made
  std::size_t experiment_bytes = 0;                 // of the experiment itself
  double kept_bytes = 0, gap_bytes = 0;             // of what it has come to keep, and of gaps between
  double preparing_bytes = 0, realising_bytes = 0;  // at most, besides these and what is recorded
  std::size_t program_bytes = 0;                    // of the program and its libraries, as far as the play used them
};

using Maker = std::function<std::unique_ptr<coupling::Experiment>(scene::Scene scene)>;

// Stops after about `budget` seconds of CPU time.
Rehearsal rehearse(const scene::Scene& scene, const Maker& make, double budget);

}  // namespace shmoo::run
