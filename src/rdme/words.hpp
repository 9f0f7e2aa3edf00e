#pragma once
// Random numbers for exact event sampling, drawn many at a time.
#include <array>
#include <cstddef>
#include <cstdint>

#include "base/random.hpp"

namespace shmoo::rdme {

// One attempt at an event: what it needs of chance.
struct Attempts {
  static constexpr std::size_t size = 32;
  alignas(64) std::array<double, size> wait;  // exponential, mean 1
  std::array<double, size> choice;            // uniform in (0, 1), 52 bits
  std::array<std::uint32_t, size> word;       // for a jump's target
};

// An endless row of attempts at one address.
class AttemptSequence {
 public:
  // a, b: the address, b < 2^16.
  AttemptSequence(const base::RandomKey& key, base::Stream stream, std::uint64_t step, std::uint32_t a = 0,
                  std::uint32_t b = 0)
      : key_(key), stream_(stream), step_(step), a_(a), b_(b), sequence_(key, stream, step, a, b) {}

  void next(Attempts& attempts);

 private:
  static constexpr std::size_t blocks = 5 * Attempts::size / 4;  // five words an attempt

  base::RandomKey key_;
  base::Stream stream_;
  std::uint64_t step_;
  std::uint32_t a_, b_;
  base::RandomSequence sequence_;
  std::uint32_t chapter_ = 0;  // added to b in its upper half: goes up where a sequence's 2^34 words end
  std::uint64_t drawn_ = 0;    // blocks of this chapter
};

}  // namespace shmoo::rdme
