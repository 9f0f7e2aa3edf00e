#pragma once
// Exact events by rejection from bounds that all voxels share: of each species the largest number in any voxel bounds
// its jumps and its reactions. Attempts come at the sum of all bounds, so how many there are in a time is a Poisson
// number, and each names a voxel and a channel by one random number; it is an event with the probability of the
// channel's rate over its bound (thinning: Lewis and Shedler 1979; for reactions Thanh, Priami, Zunino 2014, J. Chem.
// Phys. 141, 134116). Nothing is stored but numbers of molecules, so an event changes nothing else. This pays where
// voxels are much alike.
//
// Attempts are surveyed many at a time, without branches: those stay open that would be events with one molecule more
// of each species in their voxel. They are settled one by one, by the numbers as they then stand. Where a second
// molecule may have come to the same place, the rest is surveyed anew.
//
// Where an event passes a bound, the bound is raised: of K attempts in a time T the k-th comes at T Beta(k, K + 1 - k),
// and from there on attempts are drawn anew.
#include <array>
#include <vector>

#include "rdme/propensity.hpp"
#include "rdme/samplers/bounded_channel.hpp"
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
  static constexpr std::size_t batch = 64;          // attempts
  static constexpr std::size_t most_channels = 32;  // looked at one by one

  double rate(const BoundedChannel& channel, std::size_t voxel) const;
  double rates() const;  // [1/s] of all channels of all voxels, as they stand
  double bound(const BoundedChannel& channel) const;
  void make_sieve();
  void tighten();
  void sum_bounds();
  std::uint64_t attempts(std::uint64_t number, base::RandomSequence random);
  void draw(std::size_t size, base::RandomSequence& random);
  void survey(std::size_t from, std::size_t to);
  void aim();
  std::size_t settle(std::size_t to);
  void happen(const BoundedChannel& channel, std::size_t voxel, std::size_t target);
  void react(std::size_t voxel, int reaction);
  void shift(std::size_t at, std::uint32_t species, std::int64_t amount);
  void close(std::vector<std::int64_t>& events);

  const Network& network_;
  Propensities& propensities_;
  bool possible_;  // by the network
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  const JumpTables* tables_ = nullptr;
  std::size_t species_;
  std::vector<std::int64_t> most_;  // by species: bound of the number in a voxel

  std::vector<BoundedChannel> channels_;
  std::size_t changes_ = 0;  // of any channel's event, at most
  Process process_ = Process::both;
  std::uint64_t tried_ = 0, happened_ = 0;  // since bounds were made
  std::uint64_t tally_[most_channels];      // events by channel
  bool raised_ = false;                     // a bound, by the event at hand

  // By channel, for the survey.
  struct Sieve {
    double below[most_channels + 1];  // [1/s] sum of the bounds before; the last is that of all
    double largest[most_channels];    // [1/s] coefficient; shifts are those with a molecule more
    double first_scale[most_channels], first_shift[most_channels];
    double second_scale[most_channels], second_shift[most_channels];
    std::uint32_t first[most_channels], second[most_channels];
  } sieve_;

  WordStream targets_;
  // Of the attempts at hand
  std::uint32_t voxel_[batch], channel_[batch], target_[batch];
  double rest_[batch];  // [1/s] uniform below the bound
  std::uint32_t open_[batch];
  std::size_t open_number_ = 0;
  std::array<std::uint64_t, 64> came_;  // bits of places where a molecule has come since the survey
  bool crowded_ = false;                // two may have come to the same
};

}  // namespace shmoo::rdme
