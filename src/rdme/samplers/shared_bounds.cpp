#include "rdme/samplers/shared_bounds.hpp"

#include <algorithm>
#include <bit>
#include <boost/random/beta_distribution.hpp>
#include <cmath>
#include <limits>

#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {
namespace {

constexpr double least_share = 0.125;  // of attempts that must be events: by groups one costs as much as eight attempts
constexpr std::size_t near = 8192;     // voxels that the second cache holds
constexpr std::uint64_t most_at_once = 1 << 20;  // attempts of one Poisson number, about

// Places of the stream of exact events; 0 is taken by groups of voxels, 4 by where their molecules jump.
constexpr std::uint32_t of_numbers = 1, of_targets = 2, of_attempts = 3;

double falling_power(double n, int times) {
  double product = 1.0;
  for (int k = 0; k < times; ++k) product *= std::max(n - k, 0.0);
  return product;
}

std::int64_t with_room(std::int64_t number) { return number + number / 64 + 1; }

}  // namespace

SharedBounds::SharedBounds(const Network& network, Propensities& propensities)
    : network_(network), propensities_(propensities), species_(network.species()) {
  const auto sampled = [](const Reaction& reaction) { return reaction.treatment() == Treatment::sampled; };
  possible_ = species_ > 0 && all_bounded(network) &&
              species_ + std::size_t(std::ranges::count_if(network.reactions(), sampled)) <= most_channels;
}

void SharedBounds::bind(const Voxels& voxels, State& state, const JumpTables& tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = &tables;
}

double SharedBounds::bound(const BoundedChannel& channel) const {
  if (channel.reaction < 0) return channel.largest * double(most_[channel.species]);
  double product = channel.largest;
  for (const auto& term : network_.reactions()[std::size_t(channel.reaction)].reactants)
    product *= falling_power(double(most_[std::size_t(term.species)]), term.count);
  return product * (1 + 1e-12);
}

void SharedBounds::sum_bounds() {
  sieve_.below[0] = 0.0;
  for (std::size_t c = 0; c < channels_.size(); ++c) sieve_.below[c + 1] = sieve_.below[c] + bound(channels_[c]);
}

void SharedBounds::tighten() {
  most_.assign(species_, 0);
  for (std::size_t at = 0; at < state_->count.size(); at += species_)
    for (std::size_t s = 0; s < species_; ++s) most_[s] = std::max(most_[s], state_->count[at + s]);
  std::ranges::transform(most_, most_.begin(), with_room);
  sum_bounds();
  tried_ = happened_ = 0;
}

double SharedBounds::rate(const BoundedChannel& channel, std::size_t voxel) const {
  if (channel.simple) return channel.rate(state_->count.data() + voxel * species_, voxel);
  return channel.coefficient[voxel * channel.stride] > 0.0 ? propensities_(channel.reaction, voxel) : 0.0;
}

double SharedBounds::rates() const {
  double sum = 0.0;
  for (const BoundedChannel& channel : channels_)
    for (std::size_t i = 0; i < voxels_->size(); ++i) sum += rate(channel, i);
  return sum;
}

void SharedBounds::make_sieve() {
  changes_ = 0;
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    const BoundedChannel& channel = channels_[c];
    for (std::size_t k = 0; k < channel.shift.size(); ++k)
      if (channel.shift[k].amount != 0) changes_ = std::max(changes_, k + 1);
    sieve_.largest[c] = channel.simple ? channel.largest : std::numeric_limits<double>::infinity();
    sieve_.first_scale[c] = channel.first.scale;
    sieve_.first_shift[c] = channel.first(1.0);
    sieve_.second_scale[c] = channel.second.scale;
    sieve_.second_shift[c] = channel.second(1.0);
    sieve_.first[c] = channel.first.species;
    sieve_.second[c] = channel.second.species;
    tally_[c] = 0;
  }
}

bool SharedBounds::pays(Process process) {
  if (!possible_ || !tables_->entry_rate.empty() || voxels_->size() == 0) return false;
  process_ = process;
  channels_ = bounded_channels(network_, *voxels_, *tables_, process);
  make_sieve();
  tighten();
  const double bound = double(voxels_->size()) * sieve_.below[channels_.size()];
  if (!(bound < 0x1p1000)) return false;
  return bound == 0.0 || rates() >= least_share * bound;
}

double SharedBounds::advance(double dt, const base::RandomKey& key, std::uint64_t step,
                             std::vector<std::int64_t>& events) {
  base::RandomSequence numbers(key, base::Stream::stochastic_exact, step, of_numbers);
  targets_.open({key, base::Stream::stochastic_exact, step, of_targets});
  std::uint32_t part = 0;
  const std::uint64_t enough = std::max<std::uint64_t>(8 * voxels_->size(), 1024);
  for (double left = dt; left > 0.0;) {
    const double rate = double(voxels_->size()) * sieve_.below[channels_.size()];
    if (rate == 0.0) break;
    const double now = std::min(left, double(std::min(enough, most_at_once)) / rate);
    const auto number = std::uint64_t(base::poisson(numbers, rate * now));
    const std::uint64_t made = attempts(number, {key, base::Stream::stochastic_exact, step, of_attempts, part++});
    tried_ += made;
    if (!raised_) {
      left = now < left ? left - now : 0.0;
    } else {
      left -= now * boost::random::beta_distribution<double>(double(made), double(number + 1 - made))(numbers);
      sum_bounds();
    }
    if (tried_ < enough) continue;
    close(events);
    if (double(happened_) < least_share * double(tried_)) return std::max(left, 0.0);
    tighten();
  }
  close(events);
  return 0.0;
}

void SharedBounds::close(std::vector<std::int64_t>& events) {
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    if (channels_[c].reaction < 0)
      state_->jump_events += tally_[c];
    else
      events[std::size_t(channels_[c].reaction)] += std::int64_t(tally_[c]);
    happened_ += tally_[c];
    tally_[c] = 0;
  }
}

// Returns how many were made: all, or up to the one that raised a bound.
std::uint64_t SharedBounds::attempts(std::uint64_t number, base::RandomSequence random) {
  raised_ = false;
  const bool far = voxels_->size() > near;
  const std::size_t window = std::clamp<std::size_t>(std::bit_floor(voxels_->size() / 8), 4, batch);
  for (std::uint64_t made = 0; made < number; made += batch) {
    const auto size = std::size_t(std::min<std::uint64_t>(number - made, batch));
    draw(size, random);
    for (std::size_t from = 0; from < size;) {
      const std::size_t to = std::min(from + window, size);
      survey(from, to);
      if (far) aim();
      from = settle(to);
      if (raised_) return made + from;
    }
  }
  return number;
}

// A word of 64 bits for each: its upper part is the voxel, what is left says where below the sum of bounds.
void SharedBounds::draw(std::size_t size, base::RandomSequence& random) {
  alignas(64) std::uint32_t words[2 * batch];
  random.fill(words, (size + 1) / 2);
  const std::uint64_t voxels = voxels_->size();
  const std::size_t channels = channels_.size();
  const double scale = 0x1p-52 * sieve_.below[channels];
  for (std::size_t k = 0; k < size; ++k) {
    const std::uint64_t high = words[2 * k], low = words[2 * k + 1];
    const std::uint64_t upper = high * voxels, lower = low * voxels;  // voxels < 2^32
    const std::uint64_t sum = upper + (lower >> 32);
    voxel_[k] = std::uint32_t(sum >> 32);
    rest_[k] = double((sum << 32 | (lower & 0xFFFFFFFF)) >> 12) * scale;
    channel_[k] = 0;
  }
  for (std::size_t c = 1; c < channels; ++c) {
    const double below = sieve_.below[c];
    for (std::size_t k = 0; k < size; ++k) channel_[k] += rest_[k] >= below ? 1U : 0U;
  }
  if (channels == 1) return;
  for (std::size_t k = 0; k < size; ++k) rest_[k] -= sieve_.below[channel_[k]];
}

void SharedBounds::survey(std::size_t from, std::size_t to) {
  alignas(64) double most[batch];  // [1/s] rate with a molecule more
  const std::int64_t* const count = state_->count.data();
  const std::size_t species = species_;
  const Sieve& sieve = sieve_;
  if (channels_.size() == 1 && channels_[0].reaction < 0) {
    const double largest = sieve.largest[0];
    const std::uint32_t first = sieve.first[0];
    for (std::size_t k = from; k < to; ++k) most[k] = largest * (double(count[voxel_[k] * species + first]) + 1.0);
  } else {
    for (std::size_t k = from; k < to; ++k) {
      const std::uint32_t c = channel_[k];
      const std::int64_t* const n = count + voxel_[k] * species;
      most[k] = sieve.largest[c] * ((double(n[sieve.first[c]]) * sieve.first_scale[c] + sieve.first_shift[c]) *
                                    (double(n[sieve.second[c]]) * sieve.second_scale[c] + sieve.second_shift[c]));
    }
  }
  std::size_t number = 0;
  for (std::size_t k = from; k < to; ++k) {
    open_[number] = std::uint32_t(k);
    number += rest_[k] < most[k] ? 1U : 0U;
  }
  open_number_ = number;
  came_.fill(0);
  crowded_ = false;
}

// Where the open attempts would lead along rows, and what memory they will need.
void SharedBounds::aim() {
  for (std::size_t m = 0; m < open_number_; ++m) {
    const std::uint32_t k = open_[m];
    if (const JumpTable* const table = channels_[channel_[k]].table) table->prefetch(voxel_[k]);
  }
  const auto words = targets_.take(open_number_);
  for (std::size_t m = 0; m < open_number_; ++m) {
    const std::uint32_t k = open_[m];
    const JumpTable* const table = channels_[channel_[k]].table;
    target_[k] = table && !table->empty(voxel_[k]) ? table->target(voxel_[k], words[m]) : voxel_[k];
    __builtin_prefetch(state_->count.data() + target_[k] * species_, 1);
  }
}

std::size_t SharedBounds::settle(std::size_t to) {
  const bool far = voxels_->size() > near;
  const std::int64_t* const count = state_->count.data();
  for (std::size_t m = 0; m < open_number_; ++m) {
    const std::uint32_t k = open_[m];
    const BoundedChannel& channel = channels_[channel_[k]];
    const std::size_t voxel = voxel_[k];
    if (rest_[k] >= (channel.simple ? channel.rate(count + voxel * species_, voxel) : rate(channel, voxel))) continue;
    std::size_t target = voxel;
    if (channel.table) {
      target = far ? target_[k] : channel.table->target(voxel, targets_.take(1)[0]);
      if (target == voxels_->size()) [[unlikely]] {
        --state_->count[voxel * species_ + channel.species];
        ++state_->ledger.counts[channel.species].left;
        ++happened_;
        continue;
      }
    } else if (channel.reaction < 0) {
      target = tables_->unlisted[channel.species]->target(std::uint32_t(voxel), targets_);
      if (target == voxel) continue;  // it fails
    }
    ++tally_[channel_[k]];
    happen(channel, voxel, target);
    if (raised_ || crowded_) return k + 1;
  }
  return to;
}

inline void SharedBounds::shift(std::size_t at, std::uint32_t species, std::int64_t amount) {
  const std::int64_t now = state_->count[at] += amount;
  if (now > most_[species]) [[unlikely]] {
    most_[species] = with_room(now);
    raised_ = true;
  }
  const std::uint64_t more = amount > 0 ? 1U : 0U;
  std::uint64_t& word = came_[(at >> 6) % came_.size()];
  crowded_ |= (word >> (at % 64) & more) != 0 || amount > 1;
  word |= more << (at % 64);
}

inline void SharedBounds::happen(const BoundedChannel& channel, std::size_t voxel, std::size_t target) {
  if (!channel.whole) [[unlikely]]
    return react(voxel, channel.reaction);
  for (std::size_t j = 0; j < changes_; ++j) {
    const auto& [species, amount] = channel.shift[j];
    shift((j == 1 ? target : voxel) * species_ + species, species, amount);
  }
}

// An event that changes more than four numbers, or amounts.
void SharedBounds::react(std::size_t voxel, int reaction) {
  for (const Change& change : network_.reactions()[std::size_t(reaction)].changes) {
    const std::size_t at = voxel * species_ + std::size_t(change.species);
    if (network_.stochastic(change.species))
      shift(at, std::uint32_t(change.species), change.amount);
    else
      state_->amount[at] += change.amount;
  }
}

}  // namespace shmoo::rdme
