#include "base/random.hpp"

#include <array>
#include <boost/random/binomial_distribution.hpp>
#include <boost/random/poisson_distribution.hpp>
#include <numbers>

namespace shmoo::base {
namespace {

// Philox4x32-10 on several counters side by side, laid out so that a compiler puts them into the lanes of one register.
constexpr int lanes = 16;

void philox_lanes(std::uint32_t counter, const std::array<std::uint32_t, 4>& rest, std::uint32_t key0,
                  std::uint32_t key1, std::uint32_t* words) {
  alignas(64) std::uint32_t c0[lanes], c1[lanes], c2[lanes], c3[lanes];
  for (int l = 0; l < lanes; ++l) {
    c0[l] = counter + static_cast<std::uint32_t>(l);
    c1[l] = rest[1];
    c2[l] = rest[2];
    c3[l] = rest[3];
  }
  for (int round = 0; round < 10; ++round) {
    for (int l = 0; l < lanes; ++l) {
      const std::uint64_t p0 = std::uint64_t{0xD2511F53} * c0[l], p1 = std::uint64_t{0xCD9E8D57} * c2[l];
      c0[l] = static_cast<std::uint32_t>(p1 >> 32) ^ c1[l] ^ key0;
      c1[l] = static_cast<std::uint32_t>(p1);
      c2[l] = static_cast<std::uint32_t>(p0 >> 32) ^ c3[l] ^ key1;
      c3[l] = static_cast<std::uint32_t>(p0);
    }
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  for (int l = 0; l < lanes; ++l) {
    words[4 * l] = c0[l];
    words[4 * l + 1] = c1[l];
    words[4 * l + 2] = c2[l];
    words[4 * l + 3] = c3[l];
  }
}

}  // namespace

void RandomSequence::fill(std::uint32_t* words, std::size_t blocks) {
  const std::array<std::uint32_t, 4> rest{0, counter_[1], counter_[2], counter_[3]};
  for (; blocks >= lanes; blocks -= lanes, words += 4 * lanes) {
    philox_lanes(counter_[0], rest, key_[0], key_[1], words);
    counter_[0] += lanes;
  }
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
