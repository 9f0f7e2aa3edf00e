#include "rdme/samplers/uniformised.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <limits>
#include <utility>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::int64_t few = 512;        // molecules of a voxel that are moved one by one
constexpr double least_chance = 0x1p-9;  // below it 32 bits are too coarse for a yes or no
constexpr std::size_t batch = 32;        // words

// Words of a sequence, kept from the start on.
class WordList {
 public:
  explicit WordList(base::RandomSequence& random) : random_(random) {}
  const std::uint32_t* first(std::size_t words) {
    if (words > ready_) {
      const std::size_t more = (words - ready_ + batch - 1) / batch * batch;
      random_.fill(words_ + ready_, more / 4);
      ready_ += more;
    }
    return words_;
  }

 private:
  base::RandomSequence& random_;
  std::size_t ready_ = 0;
  alignas(64) std::uint32_t words_[2 * few + 2 * batch];
};

}  // namespace

void UniformisedDiffusion::Chances::set(double to) {
  if (to == mean) return;
  mean = to;
  resident.clear();
  entrant.clear();
  std::vector<double> at_least{1.0};  // P(M >= r)
  while (at_least.back() > std::numeric_limits<double>::min()) {
    at_least.push_back(boost::math::gamma_p(static_cast<double>(at_least.size()), mean));
  }
  // E[max(0, M - r)] = sum over k > r of P(M >= k)
  std::vector<double> beyond(at_least.size(), 0.0);
  for (std::size_t r = at_least.size() - 1; r-- > 0;) beyond[r] = beyond[r + 1] + at_least[r + 1];
  for (std::size_t r = 1; r < at_least.size(); ++r) {
    resident.push_back(at_least[r] / at_least[r - 1]);
    entrant.push_back(beyond[r - 1] > 0 ? beyond[r] / beyond[r - 1] : 0.0);
  }
  entrant.front() = beyond[1] / mean;  // beyond[0] is the mean itself, but for round-off
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

void UniformisedDiffusion::rounds(Walk& walk, base::Stream stream, const std::vector<double>& chances) {
  std::uint32_t number = 0;
  for (;;) {
    const double chance = number < chances.size() ? chances[number] : 0.0;
    if (std::uint64_t{++number} * walk.stride + walk.species > std::numeric_limits<std::uint32_t>::max()) {
      throw base::RunError(
          "a molecule makes more moves in one splitting step than random numbers are addressed for; take a "
          "shorter step");
    }
    round(walk, stream, number, chance);
    std::swap(active_, next_);
    walk.exits += std::exchange(active_[walk.voxels], 0);
    if (std::ranges::all_of(active_, [](std::int64_t n) { return n == 0; })) return;
  }
}

void UniformisedDiffusion::round(Walk& walk, base::Stream stream, std::uint32_t number, double chance) {
  for (std::uint32_t i = 0; i < walk.voxels; ++i) {
    if (active_[i] == 0) continue;
    base::RandomSequence random(walk.address->key, stream, walk.address->step, i, number * walk.stride + walk.species);
    if (active_[i] <= few) {
      move_few(walk, i, random, chance);
    } else {
      move_many(walk, i, random, chance);
    }
    active_[i] = 0;
  }
}

void UniformisedDiffusion::move_few(Walk& walk, std::uint32_t voxel, base::RandomSequence& random, double chance) {
  const auto here = static_cast<std::size_t>(active_[voxel]);
  std::size_t going = here, used = 0;
  WordList list(random);
  if (chance < least_chance) {
    going = static_cast<std::size_t>(base::binomial(random, active_[voxel], chance));
  } else if (chance < 1) {
    const auto limit = static_cast<std::uint32_t>(chance * 0x1p32);
    const std::uint32_t* const words = list.first(here);
    going = 0;
    for (std::size_t k = 0; k < here; ++k) going += words[k] < limit ? 1U : 0U;
    used = here;
  }
  resting_[voxel] += static_cast<std::int64_t>(here - going);
  const std::uint32_t* const words = list.first(used + going) + used;
  std::int64_t jumps = 0;
  for (std::size_t k = 0; k < going; ++k) {
    const std::uint32_t target = walk.table->target(voxel, words[k]);
    ++next_[target];
    jumps += target != voxel ? 1 : 0;
    jumps -= target == walk.voxels ? 1 : 0;
  }
  walk.jumps += jumps;
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
