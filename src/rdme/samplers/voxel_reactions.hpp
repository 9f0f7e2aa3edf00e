#pragma once
// The reactions of single voxels over a part of a splitting step, each an exact simulation (Gillespie 1977, J. Phys.
// Chem. 81, 2340). One object per thread.
#include <cstdint>
#include <span>
#include <vector>

#include "rdme/propensity.hpp"
#include "rdme/samplers/events.hpp"
#include "rdme/state.hpp"
#include "rdme/words.hpp"

namespace shmoo::rdme {

class VoxelReactions {
 public:
  explicit VoxelReactions(const Network& network);

  // References must outlive it.
  void bind(const Voxels& voxels, State& state);

  Propensities& propensities() { return propensities_; }

  // Of voxels [begin, end), through all windows. Reads and changes nothing of other voxels; the ledger is left alone.
  void react(std::uint32_t begin, std::uint32_t end, std::span<const Window> windows, AttemptSequence sequence);

  // Books what has happened since the last time.
  void close_books() { rdme::close_books(*state_, network_, events_); }

 private:
  struct Draw {
    double wait, choice;
  };
  Draw draw();
  void react(std::uint32_t voxel, const Window& window);

  const Network& network_;
  Propensities propensities_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  std::vector<double> value_;         // propensities in one voxel, by reaction
  std::vector<std::int64_t> events_;  // by reaction
  AttemptSequence* sequence_ = nullptr;
  Attempts attempts_;
  std::size_t next_ = Attempts::size;
};

}  // namespace shmoo::rdme
