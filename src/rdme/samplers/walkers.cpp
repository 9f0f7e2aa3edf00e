#include "rdme/samplers/walkers.hpp"

#include <bit>

#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace shmoo::rdme {
namespace {

constexpr double least_chance = 0x1p-9;  // below it 32 bits are too coarse for a yes or no

std::uint32_t threshold_of(double chance) { return static_cast<std::uint32_t>(chance * 0x1p32 * (1 - 0x1p-33)); }

#ifdef __AVX512F__
constexpr std::size_t lanes = 16;

__mmask16 first(std::size_t count) { return static_cast<__mmask16>(count < lanes ? (1U << count) - 1U : 0xFFFFU); }
#endif

}  // namespace

void Moves::set(std::vector<double> chances) {
  at_least = std::move(chances);
  rare = at_least.front() < least_chance;
  const double of = rare && at_least.front() > 0 ? at_least.front() : 1.0;
  thresholds.clear();
  for (const double chance : at_least) thresholds.push_back(threshold_of(chance / of));
}

void Walkers::start(const JumpTable& table, std::uint32_t outside, const Moves& moves, WordStream& words,
                    std::int64_t* resting) {
  table_ = &table;
  outside_ = outside;
  moves_ = &moves;
  words_ = &words;
  resting_ = resting;
}

void Walkers::add(std::uint32_t voxel, std::int64_t count) {
  constexpr auto most = std::int64_t{WordStream::most};
  for (; count > most; count -= most) add_some(voxel, WordStream::most);
  add_some(voxel, static_cast<std::size_t>(count));
}

void Walkers::add_some(std::uint32_t voxel, std::size_t count) {
  if (size_ + count > WordStream::most) finish();
  std::size_t going = 0;
  if (moves_->rare) {
    const auto first = base::binomial(words_->sequence(), static_cast<std::int64_t>(count), moves_->at_least.front());
    going = choose(voxel, words_->take(static_cast<std::size_t>(first)), 0xFFFFFFFF);
  } else {
    going = choose(voxel, words_->take(count), moves_->thresholds.front());
  }
  resting_[voxel] += static_cast<std::int64_t>(count - going);
}

void Walkers::finish() {
  for (std::size_t j = 1; size_ > 0; ++j) {
    move();
    rest(moves_->thresholds[j]);
  }
}

#ifdef __AVX512F__
// Takes those whose word is below the threshold.
std::size_t Walkers::choose(std::uint32_t voxel, std::span<const std::uint32_t> words, std::uint32_t threshold) {
  const __m512i limit = _mm512_set1_epi32(static_cast<int>(threshold)),
                here = _mm512_set1_epi32(static_cast<int>(voxel));
  std::size_t size = size_;
  for (std::size_t k = 0; k < words.size(); k += lanes) {
    const __m512i some = _mm512_loadu_si512(words.data() + k);
    const __mmask16 going = _mm512_mask_cmplt_epu32_mask(first(words.size() - k), some, limit);
    _mm512_storeu_si512(word_ + size, _mm512_maskz_compress_epi32(going, some));
    _mm512_storeu_si512(place_ + size, here);
    size += static_cast<std::size_t>(std::popcount(unsigned{going}));
  }
  return size - std::exchange(size_, size);
}
#else
std::size_t Walkers::choose(std::uint32_t voxel, std::span<const std::uint32_t> words, std::uint32_t threshold) {
  std::size_t size = size_;
  for (const std::uint32_t word : words) {
    word_[size] = word;
    place_[size] = voxel;
    size += word < threshold ? 1U : 0U;
  }
  return size - std::exchange(size_, size);
}
#endif

void Walkers::move() {
  const auto chosen = words_->take(size_);
  std::int64_t made = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const std::uint32_t from = place_[k], to = table_->target(from, chosen[k]);
    place_[k] = to;
    made += to != from && to != outside_ ? 1 : 0;
  }
  jumps += made;
}

// Those whose word is not below the threshold stay where they are.
#ifdef __AVX512F__
void Walkers::rest(std::uint32_t threshold) {
  const __m512i limit = _mm512_set1_epi32(static_cast<int>(threshold));
  std::size_t going = 0;
  for (std::size_t k = 0; k < size_; k += lanes) {
    const __m512i words = _mm512_load_si512(word_ + k), places = _mm512_load_si512(place_ + k);
    const __mmask16 here = first(size_ - k), on = _mm512_mask_cmplt_epu32_mask(here, words, limit);
    alignas(64) std::uint32_t last[lanes];
    _mm512_store_si512(last, _mm512_maskz_compress_epi32(static_cast<__mmask16>(here & ~on), places));
    _mm512_storeu_si512(word_ + going, _mm512_maskz_compress_epi32(on, words));
    _mm512_storeu_si512(place_ + going, _mm512_maskz_compress_epi32(on, places));
    const auto stays = std::popcount(static_cast<unsigned>(here & ~on));
    for (int i = 0; i < stays; ++i) ++resting_[last[i]];
    going += static_cast<std::size_t>(std::popcount(unsigned{on}));
  }
  size_ = going;
}
#else
void Walkers::rest(std::uint32_t threshold) {
  std::size_t going = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const bool on = word_[k] < threshold;
    resting_[place_[k]] += on ? 0 : 1;
    const std::uint32_t word = word_[k], place = place_[k];
    word_[going] = word;
    place_[going] = place;
    going += on ? 1U : 0U;
  }
  size_ = going;
}
#endif

}  // namespace shmoo::rdme
