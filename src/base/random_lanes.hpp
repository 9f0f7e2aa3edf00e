#pragma once
// Random numbers for eight addresses side by side: of one stream and step, and of eight pairs (a, b). The key is hashed
// once a step from what the pairs share; then one Philox4x32-10 block per pair.
#include <cstdint>

#include "base/random.hpp"

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace shmoo::base {

class LaneRandom {
 public:
  static constexpr int lanes = 8;
  using Words = std::uint64_t __attribute__((vector_size(8 * lanes)));  // each below 2^32

  LaneRandom(const RandomKey& key, Stream stream, std::uint64_t step) {
    RandomSequence shared(key, stream, step);
    for (auto* word : {&key_[0], &key_[1], &rest_[0], &rest_[1]}) *word = shared();
  }

  // Four words for each of the eight pairs.
  void draw(const Words& a, const Words& b, Words (&words)[4]) const {
    Words c0 = a, c1 = b, c2 = Words{} + rest_[0], c3 = Words{} + rest_[1];
    std::uint32_t key0 = key_[0], key1 = key_[1];
    for (int round = 0; round < 10; ++round) {
      const Words p0 = product(c0, 0xD2511F53), p1 = product(c2, 0xCD9E8D57);
      c0 = (p1 >> 32) ^ c1 ^ key0;
      c1 = p1 & low;
      c2 = (p0 >> 32) ^ c3 ^ key1;
      c3 = p0 & low;
      key0 += 0x9E3779B9;
      key1 += 0xBB67AE85;
    }
    words[0] = c0, words[1] = c1, words[2] = c2, words[3] = c3;
  }

 private:
  static constexpr std::uint64_t low = 0xFFFFFFFF;

  // Every lane takes part; the masked form is used because GCC 12 warns of the plain one.
  static Words product(const Words& a, std::uint32_t b) {
#if defined(__AVX512F__)
    return Words(_mm512_maskz_mul_epu32(0xFF, __m512i(a), _mm512_set1_epi64(b)));
#else
    return a * b;
#endif
  }

  std::uint32_t key_[2], rest_[2];
};

}  // namespace shmoo::base
