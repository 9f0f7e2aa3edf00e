#pragma once
// Exact events by rejection from bounds that all voxels share: of each species the largest number in any voxel bounds
// its jumps and its reactions. Attempts come at the sum of all bounds, so how many there are in a time is a Poisson
// number, and each names a voxel and a channel by one random number; it is an event with the probability of the
// channel's rate over its bound (thinning: Lewis and Shedler 1979; for reactions Thanh, Priami, Zunino 2014, J. Chem.
// Phys. 141, 134116). Nothing is stored but numbers of molecules, so an event changes nothing else. This pays where
// voxels are much alike.
//
// Where an event passes a bound, the bound is raised: of K attempts in a time T the k-th comes at T Beta(k, K + 1 - k),
// and from there on attempts are drawn anew.
#include <vector>

#include "rdme/jump_table.hpp"
#include "rdme/propensity.hpp"
#include "rdme/sampler.hpp"
#include "rdme/samplers/word_stream.hpp"

namespace shmoo::rdme {

class SharedBounds {
 public:
  SharedBounds(const Network& network, Propensities& propensities);

  // Geometry, or who jumps how, has changed. References must outlive it.
  void bind(const Voxels& voxels, State& state, const JumpTables& tables);

  // Makes bounds from the numbers now. Are enough attempts events for this to be the faster way?
  bool pays(Process process);

  // Events of dt [s], counted by reaction in `events`, and jumps in the state. Returns what is left of dt where this
  // has ceased to pay.
  double advance(double dt, const base::RandomKey& key, std::uint64_t step, std::vector<std::int64_t>& events);

 private:
  static constexpr std::size_t batch = 64;  // attempts

  // Jumps of a species, or a reaction: at c_i u v in voxel i, where u and v are each a number, one less, or 1.
  struct Channel {
    const double* coefficient = nullptr;  // [1/s] c_i at [i * stride]
    std::size_t stride = 0;
    std::uint32_t first = 0, second = 0;  // species
    double first_scale = 0, first_shift = 1, second_scale = 0, second_shift = 1;
    int reaction = -1;          // -1: jumps
    std::uint32_t species = 0;  // that jumps
    bool simple = true;         // false: a reaction of more than two molecules, by its propensity

    double rate(const std::int64_t* n, std::size_t voxel) const {  // [1/s] by the numbers of the voxel
      return coefficient[voxel * stride] *
             ((double(n[first]) * first_scale + first_shift) * (double(n[second]) * second_scale + second_shift));
    }
  };

  void add_channels(Process process);
  Channel jumps_of(std::uint32_t species) const;
  Channel channel_of(int reaction);
  double rate(const Channel& channel, std::size_t voxel) const;
  double rates() const;  // [1/s] of all channels of all voxels, as they stand
  double bound(const Channel& channel) const;
  void sum_bounds();
  std::uint64_t attempts(std::uint64_t number, std::vector<std::int64_t>& events);
  void draw(std::size_t size);
  void fetch(std::size_t size) const;
  void jump(std::uint32_t voxel, std::uint32_t species);
  void react(std::uint32_t voxel, int reaction);
  void arrive(std::size_t at, std::uint32_t species);  // a molecule more at this place of the state

  const Network& network_;
  Propensities& propensities_;
  bool possible_;  // by the network
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  const JumpTables* tables_ = nullptr;
  std::size_t species_;
  std::vector<double> fastest_;     // [1/s] by species: largest rate of leaving a voxel
  std::vector<std::int64_t> most_;  // by species: bound of the number in a voxel

  std::vector<Channel> channels_;
  std::vector<double> below_;  // [1/s] sum of the bounds of the channels before; the last is that of all
  std::vector<std::vector<double>> coefficients_;  // of reactions: one for all voxels, or by voxel
  Process process_ = Process::both;
  double expected_ = 0;                     // share of attempts that were events when the bounds were made
  std::uint64_t tried_ = 0, happened_ = 0;  // since then
  bool raised_ = false;                     // a bound, by the event at hand

  base::RandomSequence random_{{}, base::Stream::test};
  WordStream targets_;
  std::uint32_t voxel_[batch];
  double rest_[batch];  // [1/s] uniform below the sum of bounds
};

}  // namespace shmoo::rdme
