#pragma once
// A channel of the method of shared bounds (shared_bounds.hpp): jumps of one species, or one reaction. Its rate in
// voxel i is c_i u v, where u and v are each a number, one less, or 1; its event changes at most four numbers, that of
// a jump the second in another voxel.
#include <array>
#include <cstdint>
#include <vector>

#include "rdme/jump_table.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::rdme {

struct BoundedChannel {
  struct Factor {
    std::uint32_t species = 0;
    double scale = 0, shift = 1;
    double operator()(double number) const { return number * scale + shift; }
  };
  struct Shift {
    std::uint32_t species = 0;
    std::int64_t amount = 0;
  };

  const double* coefficient = nullptr;  // [1/s] c_i at [i * stride]
  std::size_t stride = 0;
  std::vector<double> own;  // what the coefficient points to where nobody else has it
  double largest = 0;       // [1/s] of all c_i
  Factor first, second;
  std::array<Shift, 4> shift{};
  int reaction = -1;                 // -1: jumps
  std::uint32_t species = 0;         // that jumps
  const JumpTable* table = nullptr;  // of its jumps, where there are rows
  bool simple = true;                // false: a reaction of more than two molecules, by its propensity
  bool whole = true;                 // false: its event is more than those four changes of whole numbers

  // [1/s] by the numbers in the voxel
  double rate(const std::int64_t* numbers, std::size_t voxel) const {
    return coefficient[voxel * stride] *
           (first(double(numbers[first.species])) * second(double(numbers[second.species])));
  }
};

// Can all sampled reactions be channels? Mass action of whole molecules within a voxel can.
bool all_bounded(const Network& network);

// Of all species that jump and of all reactions that are sampled, as far as the process goes. The tables must outlive
// them.
std::vector<BoundedChannel> bounded_channels(const Network& network, const Voxels& voxels, const JumpTables& tables,
                                             Process process);

}  // namespace shmoo::rdme
