#pragma once
// Diffusion over a step of any length at frozen geometry, exact and without events (uniformisation: Jensen 1953, Skand.
// Aktuarietidskr. 36, 87). Molecules are independent walkers with jump generator Q. With L the largest total rate of
// any row, each makes K ~ Poisson(L dt) moves of the chain 1 + Q/L. Where a voxel holds many molecules, these move in
// rounds, in counts: in round r a molecule goes on with the probability P(K >= r)/P(K >= r - 1) and moves by its
// voxel's row. Where voxels hold few, each molecule makes all its further moves at
// once. Rounds end when all have come to rest. Exits lead to a row outside.
//
// Molecules that enter do so in Poisson numbers at uniform times u and walk for dt - u. Averaged over u their moves
// obey P(K >= r) = E[max(0, M - r)]/(L dt), M ~ Poisson(L dt), so they make rounds of their own with these
// probabilities.
//
// Random numbers are addressed by (stream, step, group of voxels, round and species). The cost of a round does not grow
// with counts where these are large. The work per molecule is L dt moves, so one voxel whose rates tower above all
// others slows all.
#include <cstdint>
#include <vector>

#include "base/random.hpp"
#include "rdme/jump_table.hpp"
#include "rdme/state.hpp"

namespace shmoo::rdme {

// Neighbours by id that share a sequence of random numbers, in diffusion and in the reactions of a splitting step.
constexpr std::uint32_t voxels_per_sequence = 256;

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
  class WordStream;
  // P(K >= r), r = 0, 1, ..., at mean number of moves `mean`.
  struct Chances {
    double mean = -1;
    std::vector<double> resident, entrant;
    void set(double to);
  };
  // What all rounds of one species and step share.
  struct Walk {
    const JumpTable* table;
    const Address* address;
    std::uint32_t species, stride;  // of the state
    std::size_t voxels;
    std::int64_t jumps = 0, exits = 0;
  };

  bool take_counts(const State& state, std::uint32_t species, std::size_t voxels);
  bool take_entries(const JumpTables& tables, double dt, Walk& walk, State& state);
  void rounds(Walk& walk, base::Stream stream, const std::vector<double>& at_least);
  void round(Walk& walk, base::Stream stream, std::uint32_t number);
  void count_moves(std::size_t here, WordStream& words);
  bool walking_pays() const;
  void move_few(Walk& walk, std::uint32_t voxel, WordStream& words);
  void walk_out(Walk& walk, std::uint32_t voxel, WordStream& words);
  void move_many(Walk& walk, std::uint32_t voxel, base::RandomSequence& random, double chance);

  std::vector<Chances> chances_;                       // by species
  std::vector<std::int64_t> resting_, active_, next_;  // by voxel, and outside
  std::vector<double> further_;                        // of the round: chance of a first, second, ... further move
  std::vector<std::size_t> going_;         // of the voxel: molecules that make a first, second, ... further move
  bool walk_out_ = false;                  // in this round
  std::vector<std::uint32_t> thresholds_;  // the same, of 2^32
};

}  // namespace shmoo::rdme
