#pragma once
// The sampled reactions of single voxels, in leaps where these pay and event by event elsewhere. One object per thread.
//
// A leap of length h (leap_condition.hpp says how long it may be) is one step of the weak trapezoidal method (Anderson
// & Mattingly 2011, Commun. Math. Sci. 9, 301, with theta = 1/2), whose error in means and variances is of second
// order:
//   n* = n + sum_r nu_r Poisson(a_r(n) h/2),    n' = n* + sum_r nu_r Poisson([2 a_r(n*) - a_r(n)]^+ h/2).
// Critical reactions, and those whose rate contains t, wait for their next event; a leap ends there. Numbers never
// become negative: a leap that would make one so is taken back and made half as long (reactants last for ten events or
// more, so this happens about once in 10^9 leaps). Where a leap would hold hardly more events than its Poisson numbers
// cost, a hundred exact events are made instead (Gillespie 1977).
#include <cstdint>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "rdme/propensity.hpp"
#include "rdme/samplers/events.hpp"
#include "rdme/samplers/leap_condition.hpp"
#include "rdme/samplers/propensity_rows.hpp"

namespace shmoo::rdme {

class LeapingReactions {
 public:
  LeapingReactions(const Network& network, double tolerance);

  void bind(const Voxels& voxels, State& state);
  Propensities& propensities() { return propensities_; }

  // Of a voxel, through a window. Reads and changes nothing of other voxels; the ledger is left alone.
  void advance(std::uint32_t voxel, const Window& window, base::RandomSequence& random);

  // Books what has happened since the last time.
  void close_books() { rdme::close_books(*state_, network_, events_); }

 private:
  void derive(std::uint32_t voxel);
  double exact_events(std::uint32_t voxel, double left, base::RandomSequence& random);
  double leap(std::uint32_t voxel, double longest, double left, base::RandomSequence& random);
  bool try_leap(std::uint32_t voxel, double h, base::RandomSequence& random);
  void add(std::uint32_t voxel, std::span<const std::int64_t> times, std::int64_t sign);
  bool nothing_negative(std::uint32_t voxel) const;
  int pick_waiting(base::RandomSequence& random) const;
  void fire_thinned(std::uint32_t voxel, int reaction, double t, base::RandomSequence& random);
  void fire(std::uint32_t voxel, int reaction);
  void choose_leaping(std::uint32_t voxel);
  double worth() const;

  const Network& network_;
  Propensities propensities_;
  LeapCondition condition_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  double end_ = 0;                                     // [s] of the window
  std::span<const int> running_;                       // reactions of the voxel
  std::vector<int> leaping_, waiting_;                 // those that leap, and those that are critical
  double waiting_rate_ = 0;                            // [1/s] of the latter together
  PropensityRows rows_;                                // of one voxel
  std::vector<double> rate_;                           // the same, by reaction
  std::vector<std::int64_t> first_, second_, events_;  // by reaction: of a leap's stages; since the books were closed
};

}  // namespace shmoo::rdme
