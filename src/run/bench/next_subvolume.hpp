#pragma once
// The next-subvolume method with a binary heap as textbooks have it (Elf & Ehrenberg 2004; Gibson & Bruck 2000): the
// yardstick of the bench, deliberately plain.
#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::run::bench {

class NextSubvolume {
 public:
  // For networks of mass action and voxels that have jumps on one graph and no exchange. The references must outlive
  // it.
  NextSubvolume(const rdme::Network& network, const rdme::Voxels& voxels, rdme::State& state);
  void events(std::uint64_t number);  // do as many

 private:
  double reaction_rate(int reaction, std::size_t voxel) const;
  double total_rate(std::size_t voxel) const;
  std::size_t fire(std::size_t voxel);  // the other voxel that changed, or the same
  void react(std::size_t voxel, double at);
  std::size_t jump(std::size_t voxel, double at);
  void redraw(std::size_t voxel);
  void rescale(std::size_t voxel);
  void sift(std::size_t place);
  void swap(std::size_t a, std::size_t b);

  const rdme::Network& network_;
  const rdme::Voxels& voxels_;
  rdme::State& state_;
  std::vector<double> jump_weight_;          // [voxels] sum of couplings
  std::vector<double> rate_, reactions_;     // [voxels] of all events, of reactions alone
  std::vector<double> time_;                 // [voxels] of the next event
  std::vector<std::uint32_t> heap_, place_;  // voxels by time; where a voxel stands
  base::RandomSequence random_;
  double now_ = 0;
};

}  // namespace shmoo::run::bench
