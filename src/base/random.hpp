#pragma once
// Counter-based random numbers: each number is a function of (seed, realisation, stream, step, a, b) and of its place
// in that address's sequence, never of a thread or of a sorted index. Philox4x32-10 (Salmon, Moraes, Dror, Shaw 2011,
// "Parallel random numbers: as easy as 1, 2, 3"), as shipped by Random123.
#include <Random123/philox.h>

#include <cmath>
#include <cstdint>
#include <limits>

namespace shmoo::base {

// The one list of streams. A stream never changes its number: results would change with it.
enum class Stream : std::uint32_t {
  placement = 1,           // jitter of particles; a = particle id
  initial_counts = 2,      // rounding and scattering of initial molecules; a = species
  thermal_noise = 3,       // a, b = the pair's ids, smaller first
  stochastic_exact = 4,    // one sequence for all events of an exact sampler in one step
  diffusion_rounds = 5,    // uniformised diffusion: a = particle id, b = species
  voxel_reactions = 6,     // reactions of one voxel in one splitting step: a = particle id
  reservoir = 7,           // molecules that enter: a = particle id, b = species
  leaps = 8,               // tau-leaping: a = particle id, b = half of the step
  langevin_reactions = 9,  // noise of smooth amounts: a = particle id, b = stage
  langevin_jumps = 10,     // of exchanges between voxels: a = particle id, b = species
  rezoning = 11,           // molecules of a wall whose columns are laid anew: a = particle id, b = species
  entering = 12,           // molecules of a particle that enters through an open side: a = particle id, b = species
  test = 1000,             // for the tests
};

struct RandomKey {
  std::uint64_t seed = 0;
  std::uint32_t realisation = 0;
};

// A sequence of 32-bit words at one address. Satisfies UniformRandomBitGenerator. `a` and `b` hold 32 bits each, step
// 64; a sequence is 2^34 words long and must not be drawn beyond that.
class RandomSequence {
 public:
  using result_type = std::uint32_t;

  RandomSequence(const RandomKey& key, Stream stream, std::uint64_t step = 0, std::uint32_t a = 0,
                 std::uint32_t b = 0) {
    // The address is hashed once through Philox itself, so that distinct addresses give independent sequences.
    const Philox::ctr_type address{{static_cast<std::uint32_t>(stream), key.realisation, a, b}};
    const Philox::key_type seed{{static_cast<std::uint32_t>(key.seed), static_cast<std::uint32_t>(key.seed >> 32)}};
    const auto hashed = Philox{}(address, seed);
    key_ = {{hashed[0], hashed[1]}};
    counter_ = {{0, static_cast<std::uint32_t>(step), static_cast<std::uint32_t>(step >> 32), hashed[2]}};
  }

  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  result_type operator()() {
    if (next_ == 4) refill();
    return block_[next_++];
  }

  std::uint64_t bits64() {
    const std::uint64_t high = (*this)();
    return high << 32 | (*this)();
  }

  // Writes the next 4 * blocks words: what as many calls would give, but many at a time. To be used at the start of a
  // sequence or after a multiple of four words.
  void fill(std::uint32_t* words, std::size_t blocks);

  // Uniform in (0, 1), 53 bits, never 0 and never 1.
  double uniform() { return (static_cast<double>(bits64() >> 12) + 0.5) * 0x1p-52; }

  // Exponential with mean 1.
  double exponential() { return -std::log(uniform()); }

  // Standard normal (Box-Muller, the second of each pair is kept).
  double normal();

 private:
  using Philox = r123::Philox4x32;

  void refill() {
    block_ = Philox{}(counter_, key_);
    ++counter_[0];
    next_ = 0;
  }

  Philox::key_type key_;
  Philox::ctr_type counter_;
  Philox::ctr_type block_{};
  int next_ = 4;
  double spare_ = 0.0;
  bool has_spare_ = false;
};

// Binomial(n, p) and Poisson(mean) numbers by rejection (Hoermann 1993, BTRD and PTRD, as in Boost.Random): the cost
// does not grow with n or the mean. n >= 0, 0 <= p <= 1, mean >= 0.
std::int64_t binomial(RandomSequence& random, std::int64_t n, double p);
std::int64_t poisson(RandomSequence& random, double mean);

}  // namespace shmoo::base
