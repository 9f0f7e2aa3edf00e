#include "rdme/words.hpp"

#include <bit>

namespace shmoo::rdme {
namespace {

// In (0, 1), never 0 and never 1.
inline double uniform(std::uint32_t high, std::uint32_t low) {
  const std::uint64_t bits = (std::uint64_t{high} << 32 | low) >> 12;
  return std::bit_cast<double>(bits | 0x3FF0000000000000) - (1.0 - 0x1p-53);
}

// -ln x, for normal x > 0, to a few units in the last place: x = 2^e m with m in [sqrt(1/2), sqrt(2)), and
// ln m = 2 artanh s, s = (m - 1)/(m + 1), |s| < 0.172, by its series. Without branches, so that a loop of it becomes
// vector code, which the library's logarithm does not.
inline double minus_log(double x) {
  constexpr std::uint64_t root_half = 0x3FE6A09E667F3BCD;  // bits of sqrt(1/2)
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) - root_half;
  const double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFF) + root_half);
  // The exponent, negative or zero here, added to 2^52 + 2^51 as a whole number and taken away as a real one.
  const std::int64_t exponent = static_cast<std::int64_t>(bits) >> 52;
  const double e = std::bit_cast<double>(exponent + 0x4338000000000000) - 0x1.8p52;
  const double s = (m - 1.0) / (m + 1.0), z = s * s;
  double sum = 1.0 / 23;
  for (int k = 21; k >= 1; k -= 2) sum = sum * z + 1.0 / k;
  return -(e * 0.69314718055994530942 + 2.0 * s * sum);
}

}  // namespace

void AttemptSequence::next(Attempts& attempts) {
  constexpr std::size_t n = Attempts::size;
  if (drawn_ + blocks > std::uint64_t{1} << 32) {
    sequence_ = base::RandomSequence(key_, stream_, step_, a_, b_ + (++chapter_ << 16));
    drawn_ = 0;
  }
  alignas(64) std::uint32_t words[4 * blocks];
  sequence_.fill(words, blocks);
  drawn_ += blocks;
  for (std::size_t k = 0; k < n; ++k) attempts.choice[k] = uniform(words[k], words[n + k]);
  for (std::size_t k = 0; k < n; ++k) attempts.wait[k] = minus_log(uniform(words[2 * n + k], words[3 * n + k]));
  for (std::size_t k = 0; k < n; ++k) attempts.word[k] = words[4 * n + k];
}

}  // namespace shmoo::rdme
