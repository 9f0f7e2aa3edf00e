#include "rdme/samplers/uniformised.hpp"

#include <omp.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <limits>
#include <utility>

#include "base/error.hpp"
#include "rdme/samplers/share_groups.hpp"
#include "rdme/samplers/wanderers.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::int64_t worth_threads = 20000;  // molecules that move

// What work costs [ns], measured, where rows are `blocks` long: each move of a molecule that walks to its end, a
// molecule that makes one move among its voxel's, a voxel that is moved in counts, and looking at any voxel.
struct Costs {
  explicit Costs(double blocks) : walk(1 + 4 * blocks), single(1 + 1.7 * blocks), row(50 + 300 * blocks) {}
  double walk, single, row, look = 20;
};
constexpr double rounds_after = 6;  // the last molecules make about this many moves more than the mean

// P(K >= number + j)/P(K >= number), j = 1, 2, ..., to the last that is not 0, and 0.
std::vector<double> further(const std::vector<double>& at_least, std::size_t number) {
  std::vector<double> chances;
  for (std::size_t r = number + 1; r < at_least.size() && at_least[r] >= 0x1p-64 * at_least[number]; ++r)
    chances.push_back(at_least[r] / at_least[number]);
  chances.push_back(0.0);
  return chances;
}

// The first of these alone.
std::vector<double> next(const std::vector<double>& at_least, std::size_t number) {
  const bool any = number + 1 < at_least.size() && at_least[number + 1] >= 0x1p-64 * at_least[number];
  return any ? std::vector{at_least[number + 1] / at_least[number], 0.0} : std::vector{0.0};
}

// Sums of all that comes after.
std::vector<double> sums_beyond(const std::vector<double>& values) {
  std::vector<double> sums(values.size(), 0.0);
  for (std::size_t r = values.size() - 1; r-- > 0;) sums[r] = sums[r + 1] + values[r + 1];
  return sums;
}

}  // namespace

void UniformisedDiffusion::Chances::set(double to) {
  if (to == mean) return;
  mean = to;
  resident = {1.0};  // P(M >= r)
  while (resident.back() > std::numeric_limits<double>::min()) {
    resident.push_back(boost::math::gamma_p(static_cast<double>(resident.size()), mean));
  }
  // E[max(0, M - r)]/E[M], and the former is the sum over k > r of P(M >= k).
  entrant = beyond_resident = sums_beyond(resident);
  for (std::size_t r = 1; r < entrant.size(); ++r) entrant[r] /= mean;
  entrant[0] = 1.0;  // but for round-off
  beyond_entrant = sums_beyond(entrant);
}

void UniformisedDiffusion::advance(const JumpTables& tables, double dt, const Address& address, State& state) {
  const auto stride = static_cast<std::uint32_t>(state.species);
  const auto voxels = static_cast<std::uint32_t>(stride > 0 ? state.count.size() / stride : 0);
  chances_.resize(stride);
  active_.assign(voxels + 1, 0);
  for (std::uint32_t s = 0; s < stride; ++s) {
    const Walk walk{tables.of_species[s].get(), &address, s, stride, voxels};
    if (tables.unlisted[s]) {
      wander(tables, dt, walk, state);
      continue;
    }
    if (!walk.table) {
      if (take_entries(tables, dt, walk, state) == 0) continue;
      for (std::size_t i = 0; i < voxels; ++i) state.count[i * stride + s] += std::exchange(active_[i], 0);
      continue;
    }
    chances_[s].set(tables.uniform_rate[s] * dt);
    const std::int64_t residents = take_counts(state, s, voxels);
    start_lanes(residents, voxels);
    if (residents > 0) rounds(walk, base::Stream::diffusion_rounds, chances_[s]);
    const std::int64_t entrants = take_entries(tables, dt, walk, state);
    if (entrants > 0) rounds(walk, base::Stream::reservoir, chances_[s]);
    if (residents > 0 || entrants > 0) close(walk, state);
  }
}

std::int64_t UniformisedDiffusion::take_counts(const State& state, std::uint32_t species, std::uint32_t voxels) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < voxels; ++i) sum += active_[i] = state.count[i * state.species + species];
  return sum;
}

std::int64_t UniformisedDiffusion::take_entries(const JumpTables& tables, double dt, const Walk& walk, State& state) {
  if (tables.entry_rate.empty()) return 0;
  std::int64_t sum = 0;
  for (std::uint32_t i = 0; i < walk.voxels; ++i) {
    const double rate = tables.entry_rate[i * std::size_t{walk.stride} + walk.species];
    if (rate <= 0) continue;
    base::RandomSequence random(walk.address->key, base::Stream::reservoir, walk.address->step, i, walk.species);
    sum += active_[i] = base::poisson(random, rate * dt);
  }
  state.ledger.counts[walk.species].entered += sum;
  return sum;
}

// Where jumps are unlisted few molecules make any, each by itself. Nothing enters or leaves there.
void UniformisedDiffusion::wander(const JumpTables& tables, double dt, const Walk& walk, State& state) {
  const std::int64_t residents = take_counts(state, walk.species, walk.voxels);
  if (residents == 0) return;
  start_lanes(residents, walk.voxels);
  chances_[walk.species].set(tables.uniform_rate[walk.species] * dt);
  moves_.set(further(chances_[walk.species].resident, 0));
  share_groups(walk.voxels, threads_, [&](std::uint32_t begin, std::uint32_t end, std::size_t thread) {
    Lane& lane = lanes_[thread];
    lane.words.open(
        {walk.address->key, base::Stream::diffusion_rounds, walk.address->step, begin, walk.stride + walk.species});
    Wanderers wanderers(tables, walk.species, moves_, lane.words);
    for (std::uint32_t i = begin; i < end; ++i)
      lane.jumps += wanderers.move(i, std::exchange(active_[i], 0), lane.resting.data());
  });
  close(walk, state);
}

void UniformisedDiffusion::start_lanes(std::int64_t molecules, std::uint32_t voxels) {
  threads_ = molecules < worth_threads ? 1 : static_cast<std::size_t>(omp_get_max_threads());
  if (lanes_.size() < threads_) lanes_.resize(threads_);
  for (std::size_t k = 0; k < threads_; ++k) {
    lanes_[k].resting.resize(voxels + 1);
    lanes_[k].next.resize(voxels + 1);
  }
}

void UniformisedDiffusion::rounds(const Walk& walk, base::Stream stream, const Chances& chances) {
  const auto& at_least = stream == base::Stream::reservoir ? chances.entrant : chances.resident;
  const auto& beyond = stream == base::Stream::reservoir ? chances.beyond_entrant : chances.beyond_resident;
  std::uint32_t number = 0;
  do {
    choose_way(*walk.table, beyond[number] / at_least[number]);
    moves_.set(walk_out_ ? further(at_least, number) : next(at_least, number));
    if (std::uint64_t{++number} * walk.stride + walk.species > std::numeric_limits<std::uint32_t>::max()) {
      throw base::RunError(
          "a molecule makes more moves in one splitting step than random numbers are addressed for; take a "
          "shorter step");
    }
    round(walk, stream, number);
  } while (gather());
}

// Do all walk to their end, or make one move? Where many share a voxel rounds are cheaper, as molecules meet again in
// each. `mean`: moves that a molecule still makes.
void UniformisedDiffusion::choose_way(const JumpTable& table, double mean) {
  const Costs costs(table.mean_blocks());
  const double rounds = mean + rounds_after;
  double walking = 0, together = 0;
  for (const std::int64_t here : active_) {
    if (here == 0) continue;
    const auto n = static_cast<double>(here);
    walking += (1 + costs.walk * mean) * n;
    together += costs.look * rounds + std::min(costs.row * rounds, costs.single * n * (mean + 1));
  }
  walk_out_ = walking <= together;
  many_ = costs.row / costs.single;
}

void UniformisedDiffusion::round(const Walk& walk, base::Stream stream, std::uint32_t number) {
  const std::uint32_t address = number * walk.stride + walk.species;
  share_groups(walk.voxels, threads_, [&](std::uint32_t begin, std::uint32_t end, std::size_t thread) {
    move_group(walk, {walk.address->key, stream, walk.address->step, begin, address}, begin, end, lanes_[thread]);
  });
}

void UniformisedDiffusion::move_group(const Walk& walk, const base::RandomSequence& random, std::uint32_t begin,
                                      std::uint32_t end, Lane& lane) {
  lane.words.open(random);
  lane.walkers.start(*walk.table, walk.voxels, moves_, lane.words, lane.resting.data());
  for (std::uint32_t i = begin; i < end; ++i) {
    if (active_[i] == 0) continue;
    if (walk_out_) {
      lane.walkers.add(i, active_[i]);
    } else if (static_cast<double>(active_[i]) > many_) {
      move_many(walk, i, lane);
    } else {
      move_few(walk, i, lane);
    }
    active_[i] = 0;
  }
  lane.walkers.finish();
}

// One move of a few molecules, which may go on among many.
void UniformisedDiffusion::move_few(const Walk& walk, std::uint32_t voxel, Lane& lane) {
  const auto here = static_cast<std::size_t>(active_[voxel]);
  std::size_t going = 0;
  if (moves_.rare) {
    going = static_cast<std::size_t>(base::binomial(lane.words.sequence(), active_[voxel], moves_.at_least.front()));
  } else {
    const std::uint32_t threshold = moves_.thresholds.front();
    for (const std::uint32_t word : lane.words.take(here)) going += word < threshold ? 1U : 0U;
  }
  lane.resting[voxel] += static_cast<std::int64_t>(here - going);
  lane.more = lane.more || going > 0;
  std::int64_t* const next = lane.next.data();
  const std::int64_t unmoved = next[voxel];
  for (const std::uint32_t word : lane.words.take(going)) ++next[walk.table->target(voxel, word)];
  lane.jumps += static_cast<std::int64_t>(going) - (next[voxel] - unmoved) - next[walk.voxels];
  lane.resting[walk.voxels] += std::exchange(next[walk.voxels], 0);
}

// One binomial number for all that go on, then one for each entry of the row.
void UniformisedDiffusion::move_many(const Walk& walk, std::uint32_t voxel, Lane& lane) {
  base::RandomSequence& random = lane.words.sequence();
  std::int64_t left = base::binomial(random, active_[voxel], moves_.at_least.front());
  lane.resting[voxel] += active_[voxel] - left;
  lane.more = lane.more || left > 0;
  double below = 0;  // of 2^32
  for (const JumpTable::Block& block : walk.table->row(voxel)) {
    for (int k = 0; k < 8 && left > 0; ++k) {
      const double up_to = static_cast<double>(block.threshold[k]) + 1.0;
      if (up_to <= below) continue;
      const std::int64_t there = base::binomial(random, left, (up_to - below) / (0x1p32 - below));
      below = up_to;
      left -= there;
      const std::uint32_t target = block.target[k];
      (target == walk.voxels ? lane.resting : lane.next)[target] += there;
      if (target != voxel && target != walk.voxels) lane.jumps += there;
    }
  }
}

// Whom the next round moves, if any.
bool UniformisedDiffusion::gather() {
  bool any = false;
  for (std::size_t k = 0; k < threads_; ++k) {
    Lane& lane = lanes_[k];
    if (!std::exchange(lane.more, false)) continue;
    if (!std::exchange(any, true)) {
      std::swap(active_, lane.next);
    } else {
      for (std::size_t i = 0; i < active_.size(); ++i) active_[i] += std::exchange(lane.next[i], 0);
    }
  }
  return any;
}

void UniformisedDiffusion::close(const Walk& walk, State& state) {
  std::int64_t* const count = state.count.data() + walk.species;
  const auto voxels = static_cast<std::ptrdiff_t>(walk.voxels);
#pragma omp parallel for schedule(static) num_threads(static_cast <int>(threads_)) if (threads_ > 1)
  for (std::ptrdiff_t i = 0; i < voxels; ++i) {
    std::int64_t sum = 0;
    for (std::size_t k = 0; k < threads_; ++k) sum += std::exchange(lanes_[k].resting[static_cast<std::size_t>(i)], 0);
    count[i * walk.stride] = sum;
  }
  for (std::size_t k = 0; k < threads_; ++k) {
    Lane& lane = lanes_[k];
    state.jump_events +=
        static_cast<std::uint64_t>(std::exchange(lane.jumps, 0) + std::exchange(lane.walkers.jumps, 0));
    state.ledger.counts[walk.species].left += std::exchange(lane.resting[walk.voxels], 0);
  }
}

}  // namespace shmoo::rdme
