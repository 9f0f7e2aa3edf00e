#pragma once
// A long run of random words at one address, drawn many at a time.
#include <array>
#include <cmath>
#include <cstdint>

#include "base/random.hpp"

namespace shmoo::rdme {

// Goes on to the next chapter (the address's `a`) where a sequence's 2^34 words end, so it never runs dry.
class Words {
 public:
  Words(const base::RandomKey& key, base::Stream stream, std::uint64_t step)
      : key_(key), stream_(stream), step_(step), sequence_(key, stream, step) {}

  std::uint32_t word() {
    if (next_ == words_.size()) refill();
    return words_[next_++];
  }

  // Uniform in (0, 1), 52 bits.
  double uniform() {
    const std::uint64_t high = word();
    return (static_cast<double>((high << 32 | word()) >> 12) + 0.5) * 0x1p-52;
  }

  double exponential() { return -std::log(uniform()); }  // mean 1

 private:
  static constexpr std::size_t blocks = 64;

  void refill() {
    if (drawn_ == std::uint64_t{1} << 32) {
      sequence_ = base::RandomSequence(key_, stream_, step_, ++chapter_);
      drawn_ = 0;
    }
    sequence_.fill(words_.data(), blocks);
    drawn_ += blocks;
    next_ = 0;
  }

  base::RandomKey key_;
  base::Stream stream_;
  std::uint64_t step_;
  base::RandomSequence sequence_;
  std::uint32_t chapter_ = 0;
  std::uint64_t drawn_ = 0;  // blocks of this chapter
  std::array<std::uint32_t, 4 * blocks> words_;
  std::size_t next_ = 4 * blocks;
};

}  // namespace shmoo::rdme
