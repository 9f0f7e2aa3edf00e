#pragma once
// Where a molecule goes: one row of cumulative probabilities per voxel, searched many entries at a time.
#include <bit>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#ifdef __AVX512VL__
#include <immintrin.h>
#endif

#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/unlisted_jumps.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

// A row is a run of blocks of one cache line each. Entry k is taken where exactly k thresholds of the row lie below a
// random word, so that probabilities hold to 2^-32.
class JumpTable {
 public:
  struct alignas(64) Block {
    std::uint32_t threshold[8];
    std::uint32_t target[8];
  };

  // Rows over `voxels` places. Target `voxels` means outside: a row of that number exists and leads to itself.
  JumpTable(std::size_t voxels, std::size_t pairs);  // sizes to expect

  // Adds the next voxel's row: weights >= 0 in any unit, and where each leads. Those of weight 0 are left out.
  void add_row(std::span<const double> weights, std::span<const std::uint32_t> targets);

  // Where a molecule of `voxel` goes, by a uniform random word. The row must not be empty.
  std::uint32_t target(std::size_t voxel, std::uint32_t word) const {
    const Block* const block = blocks_.data() + first_[voxel];
    const std::uint32_t size = first_[voxel + 1] - first_[voxel];
    std::uint32_t k = 0;
    for (std::uint32_t b = 0; b < size; ++b) k += below(block[b], word);
    return block[k / 8].target[k % 8];
  }

  std::span<const Block> row(std::size_t voxel) const {
    return {blocks_.data() + first_[voxel], blocks_.data() + first_[voxel + 1]};
  }
  bool empty(std::size_t voxel) const { return first_[voxel] == first_[voxel + 1]; }
  std::size_t bytes() const { return blocks_.size() * sizeof(Block) + first_.size() * sizeof(first_[0]); }
  double mean_blocks() const { return static_cast<double>(blocks_.size()) / static_cast<double>(first_.size() - 1); }
  void prefetch(std::size_t voxel) const { __builtin_prefetch(blocks_.data() + first_[voxel]); }

 private:
  static std::uint32_t below(const Block& block, std::uint32_t word) {
#ifdef __AVX512VL__
    const __m256i thresholds = _mm256_load_si256(reinterpret_cast<const __m256i*>(block.threshold));
    return static_cast<std::uint32_t>(
        std::popcount(_mm256_cmplt_epu32_mask(thresholds, _mm256_set1_epi32(static_cast<int>(word)))));
#else
    std::uint32_t k = 0;
    for (std::uint32_t threshold : block.threshold) k += threshold < word ? 1U : 0U;
    return k;
#endif
  }

  std::vector<std::uint32_t> first_;
  std::vector<Block> blocks_;
};

enum class Rows {
  jumps,    // a row holds what leads away, in proportion to its rate
  uniform,  // every row has the same total rate, the largest of all; what is missing leads back (uniformisation)
};

// For all stochastic species. Those with equal rows share them.
struct JumpTables {
  // Null: unlisted, or the species is deterministic, or neither jumps nor leaves anywhere.
  std::vector<std::shared_ptr<const JumpTable>> of_species;
  std::vector<std::shared_ptr<const UnlistedJumps>> unlisted;  // by species; null where there are rows, or no jumps
  std::vector<double> uniform_rate;                            // [1/s] by species: moves of one molecule, Rows::uniform
  std::vector<double> leave_rate;  // [1/s] per molecule, jumps and exit, entry [voxel * species + s]
  std::vector<double> entry_rate;  // [molecules/s], the same shape; empty where nothing enters

  bool moves(std::size_t s) const { return of_species[s] || unlisted[s]; }

  mutable std::mutex mutex;
  mutable std::shared_ptr<const JumpTables> listed;  // the same with rows for all, once someone has asked for them
};

// Throws base::RunError where a rate is negative or not finite.
std::shared_ptr<const JumpTables> make_jump_tables(const Network& network, const Voxels& voxels, Rows rows);

// These tables, or where so many molecules are going to jump in dt [s] that rows pay, what has rows for all species.
std::shared_ptr<const JumpTables> with_rows_that_pay(std::shared_ptr<const JumpTables> tables, const Network& network,
                                                     const Voxels& voxels, const State& state, double dt, Rows rows);

}  // namespace shmoo::rdme
