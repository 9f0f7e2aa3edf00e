#pragma once
// Molecules that make all their moves one after the other, many molecules side by side. Which molecules of a voxel are
// looked at does not matter, so each is but a place and a word that says how many moves it makes.
#include <cstdint>
#include <span>
#include <vector>

#include "rdme/jump_table.hpp"
#include "rdme/samplers/word_stream.hpp"

namespace shmoo::rdme {

// The number K of moves that a molecule still makes.
struct Moves {
  std::vector<double> at_least;           // P(K >= 1), P(K >= 2), ..., 0
  std::vector<std::uint32_t> thresholds;  // K >= j where a random word is below the j-th
  bool rare = false;  // a first move is too rare for 32 bits: how many make it is a binomial number, and thresholds are
                      // of those only

  void set(std::vector<double> chances);  // down to 0
};

class Walkers {
 public:
  // What is added from here on moves along the rows of `table`, where `outside` is the last; `resting` by place is
  // where molecules come to rest. References must outlive the walk.
  void start(const JumpTable& table, std::uint32_t outside, const Moves& moves, WordStream& words,
             std::int64_t* resting);
  void add(std::uint32_t voxel, std::int64_t count);
  void finish();  // all walk until they rest

  std::int64_t jumps = 0;  // so far, from voxel to voxel

 private:
  void add_some(std::uint32_t voxel, std::size_t count);
  std::size_t choose(std::uint32_t voxel, std::span<const std::uint32_t> words, std::uint32_t threshold);
  void move();
  void rest(std::uint32_t threshold);

  const JumpTable* table_ = nullptr;
  const Moves* moves_ = nullptr;
  WordStream* words_ = nullptr;
  std::int64_t* resting_ = nullptr;
  std::uint32_t outside_ = 0;
  std::size_t size_ = 0;
  static constexpr std::size_t room = WordStream::most + 16;
  alignas(64) std::uint32_t place_[room];
  alignas(64) std::uint32_t word_[room];
};

}  // namespace shmoo::rdme
