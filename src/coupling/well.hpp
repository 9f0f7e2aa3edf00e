#pragma once
// One realisation of a well-mixed scene at a time, in one voxel of volume 1.
#include <memory>

#include "coupling/experiment.hpp"
#include "coupling/splitting.hpp"
#include "coupling/well_records.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/event_clock.hpp"
#include "rdme/langevin.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::coupling {

// What all realisations share.
struct WellPlan {
  // `reference`: molecules by species, for the splitting step.
  WellPlan(const scene::Scene& as_said, const std::vector<double>& reference);

  bool random() const;
  rdme::State start(const base::RandomKey& key) const;

  scene::Scene scene;  // in numbers
  rdme::Network network;
  rdme::Voxels voxels;
  Step step;
  WellRecords records;

 private:
  std::unique_ptr<rdme::State> same_start_;  // where nothing about it is left to chance
};

class Well {
 public:
  explicit Well(const WellPlan& plan);

  // From the first molecule to the last record. Returns false if stopped.
  bool realise(const base::RandomKey& key, RecordSink& sink, const Progress& progress, Outcome& outcome);

 private:
  void advance_to(double target);
  void add_langevin();
  void advance(double end);
  void advance_sampler(double start, double dt, double end);
  void act();

  const WellPlan& plan_;
  WellRecords::Reader reader_;
  std::unique_ptr<rdme::Sampler> sampler_;             // null where no species is stochastic
  std::unique_ptr<rdme::LangevinSolver> langevin_;     // null where no species is Langevin
  std::unique_ptr<rdme::DeterministicSolver> solver_;  // null where no species is deterministic
  rdme::EventClock events_;
  std::shared_ptr<const rdme::JumpTables> tables_;
  rdme::State state_;
  base::RandomKey key_;
  double time_ = 0;          // [s]
  std::uint64_t steps_ = 0;  // so far, of this realisation
  bool look_soon_ = false;   // a comparison may stand at equality, which it leaves at once
};

}  // namespace shmoo::coupling
