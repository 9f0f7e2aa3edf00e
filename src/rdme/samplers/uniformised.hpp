#pragma once
// Diffusion over a step of any length at frozen geometry, exact and without events (uniformisation: Jensen 1953, Skand.
// Aktuarietidskr. 36, 87). Molecules are independent walkers with jump generator Q. With L the largest total rate of
// any row, each makes K ~ Poisson(L dt) moves of the chain 1 + Q/L. Where a voxel holds many molecules, these move in
// rounds, in counts: in round r a molecule goes on with the probability P(K >= r)/P(K >= r - 1) and moves by its
// voxel's row. Where a voxel holds few, each molecule makes all its further moves at once (walkers.hpp). Rounds end
// when all have come to rest. Exits lead to a row outside.
//
// Molecules that enter do so in Poisson numbers at uniform times u and walk for dt - u. Averaged over u their moves
// obey P(K >= r) = E[max(0, M - r)]/(L dt), M ~ Poisson(L dt), so they make rounds of their own with these
// probabilities.
//
// Random numbers are addressed by (stream, step, group of voxels, round and species); groups are shared out among the
// threads, whose whole numbers are added up in the end. The cost of a round does not grow
// with counts where these are large. The work per molecule is L dt moves, so one voxel whose rates tower above all
// others slows all.
#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "rdme/jump_table.hpp"
#include "rdme/samplers/walkers.hpp"
#include "rdme/state.hpp"

namespace shmoo::rdme {

// Where a step finds its random numbers.
struct Address {
  base::RandomKey key;
  std::uint64_t step = 0;
};

class UniformisedDiffusion {
 public:
  // `tables` of Rows::uniform. Moves all stochastic species of the state for dt [s] and keeps its ledger.
  void advance(const JumpTables& tables, double dt, const Address& address, State& state);

 private:
  // P(K >= r), r = 0, 1, ..., at mean number of moves `mean`.
  struct Chances {
    double mean = -1;
    std::vector<double> resident, entrant;
    std::vector<double> beyond_resident, beyond_entrant;  // sum over k > r of P(K >= k)
    void set(double to);
  };
  // What all rounds of one species and step share.
  struct Walk {
    const JumpTable* table;
    const Address* address;
    std::uint32_t species, stride;  // of the state
    std::uint32_t voxels;
  };
  // What one thread moves.
  struct Lane {
    std::vector<std::int64_t> resting, next;  // by voxel, and outside: molecules at rest, and of the next round
    Walkers walkers;
    WordStream words;
    bool more = false;  // is there a next round?
    std::int64_t jumps = 0;
  };

  std::int64_t take_counts(const State& state, std::uint32_t species, std::uint32_t voxels);
  std::int64_t take_entries(const JumpTables& tables, double dt, const Walk& walk, State& state);
  void wander(const JumpTables& tables, double dt, const Walk& walk, State& state);
  void start_lanes(std::int64_t molecules, std::uint32_t voxels);
  void rounds(const Walk& walk, base::Stream stream, const Chances& chances);
  void choose_way(const JumpTable& table, double mean);
  void round(const Walk& walk, base::Stream stream, std::uint32_t number);
  void move_group(const Walk& walk, const base::RandomSequence& random, std::uint32_t begin, std::uint32_t end,
                  Lane& lane);
  void move_few(const Walk& walk, std::uint32_t voxel, Lane& lane);
  void move_many(const Walk& walk, std::uint32_t voxel, Lane& lane);
  bool gather();
  void close(const Walk& walk, State& state);

  std::vector<Chances> chances_;      // by species
  std::vector<std::int64_t> active_;  // by voxel, and outside: molecules that move in this round
  std::vector<Lane> lanes_;           // of all threads
  std::size_t threads_ = 1;           // of this species and step
  Moves moves_;                       // of this round
  double many_ = 0;                   // molecules of a voxel beyond which they move in counts
  bool walk_out_ = true;              // in this round all molecules walk to their end
};

}  // namespace shmoo::rdme
