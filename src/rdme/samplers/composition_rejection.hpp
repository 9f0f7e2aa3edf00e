#pragma once
// Exact and fast: the cost of an event does not depend on the number of voxels. Where voxels are much alike, events are
// found by bounds that all share (shared_bounds.hpp). Elsewhere a voxel is found by composition and
// rejection (groups.hpp); within it species that jump, entries and reactions follow in turn; a jump's target comes from
// the voxel's row of cumulative probabilities (jump_table.hpp). A voxel's total is summed anew from its numbers at each
// change, never updated by differences, so round-off cannot drift.
#include <vector>

#include "rdme/jump_table.hpp"
#include "rdme/propensity.hpp"
#include "rdme/sampler.hpp"
#include "rdme/samplers/groups.hpp"
#include "rdme/samplers/propensity_rows.hpp"
#include "rdme/samplers/shared_bounds.hpp"
#include "rdme/samplers/word_stream.hpp"
#include "rdme/surface/beside.hpp"
#include "rdme/words.hpp"

namespace shmoo::rdme {

class CompositionRejection final : public Sampler {
 public:
  explicit CompositionRejection(const Network& network);

  std::shared_ptr<const JumpTables> prepare(const Voxels& voxels) const override;
  using Sampler::bind;
  void bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) override;
  void amounts_changed() override {
    derived_ = false;
    way_ = Way::undecided;
  }
  void watch(EventWatch* watch) override { watch_ = watch; }
  void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) override;

 private:
  void use(std::shared_ptr<const JumpTables> tables);
  bool alike();
  void derive_all();
  void refresh(std::uint32_t voxel);
  void species_changed(std::uint32_t voxel, int species);
  // Coming attempts [from, to) as they stand now.
  struct Look {
    alignas(64) std::array<std::uint32_t, Attempts::size + 8> voxel;  // and room beyond (groups.hpp)
    std::array<std::uint32_t, Attempts::size> target;                 // of a jump by the first species' rows
    std::array<double, Attempts::size + 8> rest;
    std::array<double, Attempts::size> left;  // of a pick; of the step's time [s] once the attempt is made
    std::uint64_t accepted = 0;               // bits
    std::size_t from = 0, to = 0;
    std::uint64_t version = 0;
  };
  void look_ahead(const Attempts& attempts, double left, Look& look);
  void fetch(const Look& look, const JumpTable* table) const;
  bool touched(const Look& look, std::uint32_t voxel, std::uint32_t other) const;
  std::uint32_t fire(std::uint32_t voxel, double rest, std::uint32_t word, std::uint32_t guess);
  std::uint32_t jump(std::uint32_t voxel, int species, std::uint32_t target);
  std::uint32_t react(std::uint32_t voxel, int index, double rest);
  void by_groups(double t, double dt, const base::RandomKey& key, std::uint64_t step);
  bool pass(const Window& window, double origin, AttemptSequence& sequence);

  const Network& network_;
  Propensities propensities_;
  Beside beside_;
  std::size_t species_, reactions_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  std::shared_ptr<const JumpTables> tables_;
  Process process_ = Process::both;
  bool derived_ = false;
  bool far_ = false;                         // memory is worth asking for early
  bool diffusion_ = true, reaction_ = true;  // what the process acts on
  enum class Way { undecided, shared_bounds, groups } way_ = Way::undecided;
  std::uint64_t decided_at_ = 0;  // events of the state when the way was chosen
  SharedBounds shared_;
  Groups groups_;
  std::vector<const JumpTable*> table_;  // by species; null where jumps are unlisted, or none
  WordStream targets_;                   // for jumps that are unlisted
  std::vector<std::uint32_t> mobile_;    // species that jump or leave anywhere
  const double* leave_ = nullptr;        // as in JumpTables
  const double* entry_ = nullptr;        // null where nothing enters
  std::int64_t* count_ = nullptr;
  PropensityRows rows_;
  std::vector<std::int64_t> events_;  // by reaction, of this advance
  EventWatch* watch_ = nullptr;
  bool wide_ = false;          // the event at hand changed more voxels than two
  double end_ = 0, left_ = 0;  // [s] of the window, and from the event at hand to its end
};

}  // namespace shmoo::rdme
