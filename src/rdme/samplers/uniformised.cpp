#include "rdme/samplers/uniformised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <boost/math/special_functions/gamma.hpp>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::int64_t few = 512;        // molecules of a voxel that are moved one by one
constexpr double least_chance = 0x1p-9;  // below it 32 bits are too coarse for a yes or no
constexpr double sparse = 10;            // molecules per occupied voxel that go on, up to which they walk
constexpr double short_walk = 4;         // moves
constexpr std::size_t batch = 256;       // words

// How many words lie below the threshold.
std::size_t below(std::span<const std::uint32_t> words, std::uint32_t threshold) {
  std::size_t number = 0;
#ifdef __AVX512F__
  for (std::size_t k = 0; k < words.size(); k += 16) {
    const std::size_t rest = words.size() - k;
    const auto lanes = static_cast<__mmask16>(rest < 16 ? (1U << rest) - 1U : 0xFFFFU);
    const __m512i some = _mm512_maskz_loadu_epi32(lanes, words.data() + k);
    const __m512i limit = _mm512_set1_epi32(static_cast<int>(threshold));
    number += static_cast<std::size_t>(std::popcount(unsigned{_mm512_mask_cmplt_epu32_mask(lanes, some, limit)}));
  }
#else
  for (const std::uint32_t word : words) number += word < threshold ? 1U : 0U;
#endif
  return number;
}

}  // namespace

// Words of a sequence in the order in which they are taken.
class UniformisedDiffusion::WordStream {
 public:
  explicit WordStream(const base::RandomSequence& random) : random_(random) {}
  base::RandomSequence& sequence() { return random_; }
  std::span<const std::uint32_t> take(std::size_t count) {  // at most `few`; valid until the next take
    if (ready_ - at_ < count) refill(count);
    at_ += count;
    return {words_ + at_ - count, count};
  }

 private:
  void refill(std::size_t count) {
    std::copy(words_ + at_, words_ + ready_, words_);
    ready_ -= std::exchange(at_, 0);
    const std::size_t more = std::max(batch, (count + batch - 1) / batch * batch);
    random_.fill(words_ + ready_, more / 4);
    ready_ += more;
  }
  base::RandomSequence random_;
  std::size_t at_ = 0, ready_ = 0;
  alignas(64) std::uint32_t words_[2 * few + 2 * batch];
};

void UniformisedDiffusion::Chances::set(double to) {
  if (to == mean) return;
  mean = to;
  resident = {1.0};  // P(M >= r)
  while (resident.back() > std::numeric_limits<double>::min()) {
    resident.push_back(boost::math::gamma_p(static_cast<double>(resident.size()), mean));
  }
  // E[max(0, M - r)]/E[M], and the former is the sum over k > r of P(M >= k).
  entrant.assign(resident.size(), 0.0);
  for (std::size_t r = resident.size() - 1; r-- > 0;) entrant[r] = entrant[r + 1] + resident[r + 1];
  for (std::size_t r = 1; r < entrant.size(); ++r) entrant[r] /= mean;
  entrant[0] = 1.0;  // but for round-off
}

void UniformisedDiffusion::advance(const JumpTables& tables, double dt, const Address& address, State& state) {
  const std::size_t stride = state.species, voxels = stride > 0 ? state.count.size() / stride : 0;
  chances_.resize(stride);
  resting_.resize(voxels + 1);
  active_.assign(voxels + 1, 0);
  next_.assign(voxels + 1, 0);
  for (std::uint32_t s = 0; s < stride; ++s) {
    const bool moves = tables.of_species[s] != nullptr;
    if (!moves && tables.entry_rate.empty()) continue;
    Walk walk{tables.of_species[s].get(), &address, s, static_cast<std::uint32_t>(stride), voxels, 0, 0};
    if (moves) chances_[s].set(tables.uniform_rate[s] * dt);
    std::fill(resting_.begin(), resting_.end(), 0);
    bool any = moves && take_counts(state, s, voxels);
    if (any) rounds(walk, base::Stream::diffusion_rounds, chances_[s].resident);
    if (take_entries(tables, dt, walk, state)) {
      if (moves) {
        rounds(walk, base::Stream::reservoir, chances_[s].entrant);
      } else {
        for (std::size_t i = 0; i < voxels; ++i) state.count[i * stride + s] += std::exchange(active_[i], 0);
        continue;
      }
      any = true;
    }
    if (!any) continue;
    for (std::size_t i = 0; i < voxels; ++i) state.count[i * stride + s] = resting_[i];
    state.jump_events += static_cast<std::uint64_t>(walk.jumps);
    state.ledger.counts[s].left += walk.exits;
  }
}

bool UniformisedDiffusion::take_counts(const State& state, std::uint32_t species, std::size_t voxels) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < voxels; ++i) sum += active_[i] = state.count[i * state.species + species];
  return sum > 0;
}

bool UniformisedDiffusion::take_entries(const JumpTables& tables, double dt, Walk& walk, State& state) {
  if (tables.entry_rate.empty()) return false;
  std::int64_t sum = 0;
  for (std::uint32_t i = 0; i < walk.voxels; ++i) {
    const double rate = tables.entry_rate[i * std::size_t{walk.stride} + walk.species];
    if (rate <= 0) continue;
    base::RandomSequence random(walk.address->key, base::Stream::reservoir, walk.address->step, i, walk.species);
    sum += active_[i] = base::poisson(random, rate * dt);
  }
  state.ledger.counts[walk.species].entered += sum;
  return sum > 0;
}

void UniformisedDiffusion::rounds(Walk& walk, base::Stream stream, const std::vector<double>& at_least) {
  std::uint32_t number = 0;
  for (;;) {
    further_.clear();  // P(K >= number + j)/P(K >= number), j = 1, 2, ...
    thresholds_.clear();
    for (std::size_t r = number + std::size_t{1}; r < at_least.size(); ++r) {
      if (at_least[r] < 0x1p-64 * at_least[number]) break;
      further_.push_back(at_least[r] / at_least[number]);
      thresholds_.push_back(static_cast<std::uint32_t>(further_.back() * 0x1p32 * (1 - 0x1p-33)));
    }
    further_.push_back(0.0);
    thresholds_.push_back(0);
    if (std::uint64_t{++number} * walk.stride + walk.species > std::numeric_limits<std::uint32_t>::max()) {
      throw base::RunError(
          "a molecule makes more moves in one splitting step than random numbers are addressed for; take a "
          "shorter step");
    }
    walk_out_ = walking_pays();
    round(walk, stream, number);
    std::swap(active_, next_);
    walk.exits += std::exchange(active_[walk.voxels], 0);
    if (std::ranges::all_of(active_, [](std::int64_t n) { return n == 0; })) break;
  }
  walk.exits += std::exchange(resting_[walk.voxels], 0);
}

// Walking costs more per move than moving a voxel's molecules by its one row, but less per voxel and round. Among many
// molecules, which move in counts, only the last moves are worth walking.
bool UniformisedDiffusion::walking_pays() const {
  std::int64_t sum = 0, most = 0, occupied = 0;
  for (const std::int64_t n : active_) {
    sum += n;
    most = std::max(most, n);
    occupied += n > 0 ? 1 : 0;
  }
  if (double(sum) * further_.front() > sparse * double(occupied)) return false;
  return most <= few || std::accumulate(further_.begin(), further_.end(), 0.0) < short_walk;
}

void UniformisedDiffusion::round(Walk& walk, base::Stream stream, std::uint32_t number) {
  for (std::uint32_t begin = 0; begin < walk.voxels; begin += voxels_per_sequence) {
    WordStream words({walk.address->key, stream, walk.address->step, begin, number * walk.stride + walk.species});
    const auto end =
        static_cast<std::uint32_t>(std::min<std::size_t>(walk.voxels, std::size_t{begin} + voxels_per_sequence));
    for (std::uint32_t i = begin; i < end; ++i) {
      if (active_[i] == 0) continue;
      if (active_[i] > few) {
        move_many(walk, i, words.sequence(), further_.front());
      } else if (walk_out_) {
        walk_out(walk, i, words);
      } else {
        move_few(walk, i, words);
      }
      active_[i] = 0;
    }
  }
}

// How many of `here` molecules make at least one, two, ... further moves, down to none.
void UniformisedDiffusion::count_moves(std::size_t here, WordStream& words) {
  going_.clear();
  if (further_.front() < least_chance) {  // too rare for thresholds of 32 bits
    auto left = static_cast<std::int64_t>(here);
    for (std::size_t j = 0; left > 0; ++j) {
      left = base::binomial(words.sequence(), left, j == 0 ? further_[0] : further_[j] / further_[j - 1]);
      going_.push_back(static_cast<std::size_t>(left));
    }
    return;
  }
  const auto chosen = words.take(here);
  for (std::size_t j = 0; j == 0 || going_.back() > 0; ++j) going_.push_back(below(chosen, thresholds_[j]));
}

// A few molecules make all their further moves at once. How many make a j-th one is all that is asked of their numbers
// of moves: molecules of one voxel are alike, so the first so many of them go on.
void UniformisedDiffusion::walk_out(Walk& walk, std::uint32_t voxel, WordStream& words) {
  const auto here = static_cast<std::size_t>(active_[voxel]);
  count_moves(here, words);
  resting_[voxel] += static_cast<std::int64_t>(here - going_[0]);
  std::uint32_t place[few];
  std::fill(place, place + going_[0], voxel);
  std::int64_t jumps = 0;
  for (std::size_t j = 0; going_[j] > 0; ++j) {
    const auto chosen = words.take(going_[j]);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      const std::uint32_t from = place[k], to = walk.table->target(from, chosen[k]);
      place[k] = to;
      jumps += to != from && to != walk.voxels ? 1 : 0;
    }
    for (std::size_t k = going_[j + 1]; k < going_[j]; ++k) ++resting_[place[k]];
  }
  walk.jumps += jumps;
}

// One move of a few molecules, which may go on among many.
void UniformisedDiffusion::move_few(Walk& walk, std::uint32_t voxel, WordStream& words) {
  const auto here = static_cast<std::size_t>(active_[voxel]);
  const double chance = further_.front();
  const std::size_t going = chance < least_chance
                                ? static_cast<std::size_t>(base::binomial(words.sequence(), active_[voxel], chance))
                                : below(words.take(here), thresholds_.front());
  resting_[voxel] += static_cast<std::int64_t>(here - going);
  std::int64_t* const next = next_.data();
  const JumpTable& table = *walk.table;
  const std::int64_t unmoved = next[voxel] + next[walk.voxels];
  for (const std::uint32_t word : words.take(going)) ++next[table.target(voxel, word)];
  walk.jumps += static_cast<std::int64_t>(going) - (next[voxel] + next[walk.voxels] - unmoved);
}

// One binomial number for all that go on, then one for each entry of the row.
void UniformisedDiffusion::move_many(Walk& walk, std::uint32_t voxel, base::RandomSequence& random, double chance) {
  std::int64_t left = base::binomial(random, active_[voxel], chance);
  resting_[voxel] += active_[voxel] - left;
  double below = 0;  // of 2^32
  for (const JumpTable::Block& block : walk.table->row(voxel)) {
    for (int k = 0; k < 8 && left > 0; ++k) {
      const double up_to = static_cast<double>(block.threshold[k]) + 1.0;
      if (up_to <= below) continue;
      const std::int64_t there = base::binomial(random, left, (up_to - below) / (0x1p32 - below));
      below = up_to;
      left -= there;
      next_[block.target[k]] += there;
      if (block.target[k] != voxel && block.target[k] != walk.voxels) walk.jumps += there;
    }
  }
}

}  // namespace shmoo::rdme
