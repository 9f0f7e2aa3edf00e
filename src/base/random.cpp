#include "base/random.hpp"

#include <array>
#include <boost/random/binomial_distribution.hpp>
#include <boost/random/poisson_distribution.hpp>
#include <cstring>
#include <numbers>

#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace shmoo::base {
#ifdef __AVX512F__
namespace {

// Philox4x32-10 on eight counters side by side, each word in the lower half of a lane.
constexpr int lanes = 8;
using Lanes = std::uint64_t __attribute__((vector_size(8 * lanes)));

// Every lane takes part; the masked form is used because GCC 12 warns of the plain one.
inline Lanes product(Lanes a, std::uint32_t b) {
  return (Lanes)_mm512_maskz_mul_epu32(0xFF, (__m512i)a, _mm512_set1_epi64(b));
}

void philox_lanes(const std::array<std::uint32_t, 4>& counter, std::uint32_t key0, std::uint32_t key1,
                  std::uint32_t* words) {
  constexpr std::uint64_t low = 0xFFFFFFFF;
  Lanes c0 = (Lanes{0, 1, 2, 3, 4, 5, 6, 7} + counter[0]) & low;
  Lanes c1 = Lanes{} + counter[1], c2 = Lanes{} + counter[2], c3 = Lanes{} + counter[3];
  for (int round = 0; round < 10; ++round) {
    const Lanes p0 = product(c0, 0xD2511F53), p1 = product(c2, 0xCD9E8D57);
    c0 = (p1 >> 32) ^ c1 ^ key0;
    c1 = p1 & low;
    c2 = (p0 >> 32) ^ c3 ^ key1;
    c3 = p0 & low;
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  const Lanes first = c0 | c1 << 32, second = c2 | c3 << 32;
  const Lanes left = __builtin_shuffle(first, second, Lanes{0, 8, 1, 9, 2, 10, 3, 11});
  const Lanes right = __builtin_shuffle(first, second, Lanes{4, 12, 5, 13, 6, 14, 7, 15});
  std::memcpy(words, &left, sizeof left);
  std::memcpy(words + 2 * lanes, &right, sizeof right);
}

}  // namespace
#endif

void RandomSequence::fill(std::uint32_t* words, std::size_t blocks) {
#ifdef __AVX512F__
  for (; blocks >= lanes; blocks -= lanes, words += 4 * lanes) {
    philox_lanes({counter_[0], counter_[1], counter_[2], counter_[3]}, key_[0], key_[1], words);
    counter_[0] += lanes;
  }
#endif
  for (; blocks > 0; --blocks, words += 4) {
    const auto block = Philox{}(counter_, key_);
    ++counter_[0];
    for (int i = 0; i < 4; ++i) words[i] = block[i];
  }
  next_ = 4;
}

double RandomSequence::normal() {
  if (has_spare_) {
    has_spare_ = false;
    return spare_;
  }
  const double radius = std::sqrt(2.0 * exponential());
  const double angle = 2.0 * std::numbers::pi * uniform();
  spare_ = radius * std::sin(angle);
  has_spare_ = true;
  return radius * std::cos(angle);
}

std::int64_t binomial(RandomSequence& random, std::int64_t n, double p) {
  if (n <= 0 || p <= 0.0) return 0;
  if (p >= 1.0) return n;
  return boost::random::binomial_distribution<std::int64_t, double>(n, p)(random);
}

std::int64_t poisson(RandomSequence& random, double mean) {
  if (mean <= 0.0) return 0;
  return boost::random::poisson_distribution<std::int64_t, double>(mean)(random);
}

}  // namespace shmoo::base
