#pragma once
// Molecules whose jumps are unlisted (unlisted_jumps.hpp): each makes its moves of the uniformised chain by itself. As
// with walkers.hpp one word says how many moves a molecule makes.
#include "rdme/jump_table.hpp"
#include "rdme/samplers/walkers.hpp"

namespace shmoo::rdme {

class Wanderers {
 public:
  // References must outlive it.
  Wanderers(const JumpTables& tables, std::uint32_t species, const Moves& moves, WordStream& words)
      : jumps_(*tables.unlisted[species]),
        leave_(tables.leave_rate.data() + species),
        stride_(tables.unlisted.size()),
        scale_(0x1p32 / tables.uniform_rate[species]),
        moves_(moves),
        words_(words) {}

  // `count` molecules of a voxel to where they come to `rest`, by voxel; returns how many jumps they make.
  std::int64_t move(std::uint32_t voxel, std::int64_t count, std::int64_t* rest);

 private:
  std::size_t choose(std::size_t count);

  const UnlistedJumps& jumps_;
  const double* leave_;  // [1/s] of voxels, every stride-th
  std::size_t stride_;
  double scale_;  // [s] 2^32 over the uniform rate
  const Moves& moves_;
  WordStream& words_;
  std::uint32_t word_[WordStream::most];  // of molecules that make a move
};

}  // namespace shmoo::rdme
