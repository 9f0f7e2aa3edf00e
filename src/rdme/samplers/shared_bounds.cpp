#include "rdme/samplers/shared_bounds.hpp"

#include <algorithm>
#include <boost/random/beta_distribution.hpp>
#include <cmath>

#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {
namespace {

constexpr double least_share = 0.1;              // of attempts that must be events
constexpr std::size_t most_channels = 32;        // looked at one by one
constexpr std::size_t near = 8192;               // voxels that the second cache holds
constexpr std::uint64_t most_at_once = 1 << 20;  // attempts of one Poisson number, about

// Places of the stream of exact events; 0 is taken by groups of voxels, 4 by where their molecules jump.
constexpr std::uint32_t of_numbers = 1, of_targets = 2, of_attempts = 3;

// Mass action of whole molecules within a voxel.
bool plain(const Network& network, const Reaction& reaction) {
  return reaction.expression.empty() && !reaction.on_surface() &&
         std::ranges::all_of(reaction.reactants, [&](const auto& term) { return network.stochastic(term.species); });
}

double falling_power(double n, int times) {
  double product = 1.0;
  for (int k = 0; k < times; ++k) product *= std::max(n - k, 0.0);
  return product;
}

std::int64_t with_room(std::int64_t number) { return number + number / 8 + 1; }

}  // namespace

SharedBounds::SharedBounds(const Network& network, Propensities& propensities)
    : network_(network), propensities_(propensities), species_(network.species()) {
  const auto sampled = [](const Reaction& reaction) { return reaction.treatment() == Treatment::sampled; };
  possible_ =
      species_ > 0 && network.varying().empty() &&
      std::ranges::all_of(network.reactions(), [&](const Reaction& r) { return !sampled(r) || plain(network, r); }) &&
      species_ + std::size_t(std::ranges::count_if(network.reactions(), sampled)) <= most_channels;
}

void SharedBounds::bind(const Voxels& voxels, State& state, const JumpTables& tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = &tables;
  fastest_.assign(species_, 0.0);
  for (std::size_t at = 0; at < tables.leave_rate.size(); at += species_)
    for (std::size_t s = 0; s < species_; ++s) fastest_[s] = std::max(fastest_[s], tables.leave_rate[at + s]);
  coefficients_.assign(network_.reactions().size(), {});
}

SharedBounds::Channel SharedBounds::jumps_of(std::uint32_t species) const {
  Channel channel{tables_->leave_rate.data() + species, species_};
  channel.first = channel.species = species;
  channel.first_scale = 1;
  channel.first_shift = 0;
  return channel;
}

SharedBounds::Channel SharedBounds::channel_of(int reaction) {
  const Reaction& law = network_.reactions()[std::size_t(reaction)];
  auto& coefficient = coefficients_[std::size_t(reaction)];
  const auto of = [&](std::size_t i) {
    const double volume = voxels_->volume[i];
    const std::size_t material = voxels_->material[i];  // that of vacant voxels is beyond all others
    const bool runs = material < law.in_material.size() && law.in_material[material];
    return runs ? law.rate_constant * volume_factor(law.order, volume, 1 / volume) : 0.0;
  };
  for (std::size_t i = 0; coefficient.empty() && i < voxels_->size(); ++i) {
    if (of(i) == of(0)) continue;
    for (std::size_t j = 0; j < voxels_->size(); ++j) coefficient.push_back(of(j));
  }
  if (coefficient.empty()) coefficient.push_back(of(0));
  Channel channel{coefficient.data(), coefficient.size() > 1 ? std::size_t{1} : 0};
  channel.reaction = reaction;
  channel.simple = law.order <= 2;
  int found = 0;
  for (const auto& term : law.reactants) {
    for (int k = 0; k < term.count && channel.simple; ++k, ++found) {
      (found == 0 ? channel.first : channel.second) = std::uint32_t(term.species);
      (found == 0 ? channel.first_scale : channel.second_scale) = 1;
      (found == 0 ? channel.first_shift : channel.second_shift) = -k;
    }
  }
  return channel;
}

void SharedBounds::add_channels(Process process) {
  process_ = process;
  channels_.clear();
  for (std::uint32_t s = 0; process != Process::reactions && s < species_; ++s)
    if (tables_->moves(s)) channels_.push_back(jumps_of(s));
  for (std::size_t r = 0; process != Process::diffusion && r < network_.reactions().size(); ++r)
    if (network_.reactions()[r].treatment() == Treatment::sampled) channels_.push_back(channel_of(int(r)));
}

double SharedBounds::bound(const Channel& channel) const {
  if (channel.reaction < 0) return fastest_[channel.species] * double(most_[channel.species]);
  double product = std::ranges::max(coefficients_[std::size_t(channel.reaction)]);
  for (const auto& term : network_.reactions()[std::size_t(channel.reaction)].reactants)
    product *= falling_power(double(most_[std::size_t(term.species)]), term.count);
  return product * (1 + 1e-12);
}

void SharedBounds::sum_bounds() {
  below_.assign(1, 0.0);
  for (const Channel& channel : channels_) below_.push_back(below_.back() + bound(channel));
}

double SharedBounds::rate(const Channel& channel, std::size_t voxel) const {
  if (channel.simple) return channel.rate(state_->count.data() + voxel * species_, voxel);
  return channel.coefficient[voxel * channel.stride] > 0.0 ? propensities_(channel.reaction, voxel) : 0.0;
}

double SharedBounds::rates() const {
  double sum = 0.0;
  for (const Channel& channel : channels_)
    for (std::size_t i = 0; i < voxels_->size(); ++i) sum += rate(channel, i);
  return sum;
}

bool SharedBounds::pays(Process process) {
  if (!possible_ || !tables_->entry_rate.empty() || voxels_->size() == 0) return false;
  add_channels(process);
  most_.assign(species_, 0);
  for (std::size_t at = 0; at < state_->count.size(); at += species_)
    for (std::size_t s = 0; s < species_; ++s) most_[s] = std::max(most_[s], state_->count[at + s]);
  std::ranges::transform(most_, most_.begin(), with_room);
  sum_bounds();
  tried_ = happened_ = 0;
  const double bound = double(voxels_->size()) * below_.back();
  if (!(bound < 0x1p1000)) return false;
  expected_ = bound > 0.0 ? rates() / bound : 1.0;
  return expected_ >= least_share;
}

double SharedBounds::advance(double dt, const base::RandomKey& key, std::uint64_t step,
                             std::vector<std::int64_t>& events) {
  base::RandomSequence numbers(key, base::Stream::stochastic_exact, step, of_numbers);
  targets_.open({key, base::Stream::stochastic_exact, step, of_targets});
  std::uint32_t part = 0;
  for (double left = dt; left > 0.0;) {
    const double rate = double(voxels_->size()) * below_.back();
    if (rate == 0.0) return 0.0;
    const double now = std::min(left, double(most_at_once) / rate);
    const auto number = std::uint64_t(base::poisson(numbers, rate * now));
    random_ = {key, base::Stream::stochastic_exact, step, of_attempts, part++};
    const std::uint64_t made = attempts(number, events);
    if (!raised_) {
      left = now < left ? left - now : 0.0;
    } else {
      left -= now * boost::random::beta_distribution<double>(double(made), double(number + 1 - made))(numbers);
      sum_bounds();
    }
    const bool rare = double(happened_) < 0.7 * expected_ * double(tried_);
    if (tried_ >= std::max<std::uint64_t>(voxels_->size(), 1024) && rare && !pays(process_)) return std::max(left, 0.0);
  }
  return 0.0;
}

// Returns how many were made: all, or up to the one that raised a bound.
std::uint64_t SharedBounds::attempts(std::uint64_t number, std::vector<std::int64_t>& events) {
  raised_ = false;
  const bool far = voxels_->size() > near;
  const std::int64_t* const count = state_->count.data();
  const double* const below = below_.data();
  const std::size_t last = channels_.size() - 1, species = species_;
  for (std::uint64_t made = 0; made < number; made += batch) {
    const auto size = std::size_t(std::min<std::uint64_t>(number - made, batch));
    draw(size);
    if (far) fetch(size);
    for (std::size_t k = 0; k < size; ++k) {
      std::size_t c = 0;
      for (std::size_t other = 1; other <= last; ++other) c += rest_[k] >= below[other] ? 1U : 0U;
      const Channel& channel = channels_[c];
      const std::uint32_t voxel = voxel_[k];
      const double rest = rest_[k] - below[c];
      if (rest >= (channel.simple ? channel.rate(count + voxel * species, voxel) : rate(channel, voxel))) continue;
      if (channel.reaction < 0) {
        jump(voxel, channel.species);
      } else {
        react(voxel, channel.reaction);
        ++events[std::size_t(channel.reaction)];
      }
      if (!raised_) continue;
      tried_ += made + k + 1;
      return made + k + 1;
    }
  }
  tried_ += number;
  return number;
}

// A word of 64 bits for each: its upper part is the voxel, what is left says where below the sum of bounds.
void SharedBounds::draw(std::size_t size) {
  alignas(64) std::uint32_t words[2 * batch];
  random_.fill(words, (size + 1) / 2);
  const std::uint64_t voxels = voxels_->size();
  const double scale = 0x1p-52 * below_.back();
  for (std::size_t k = 0; k < size; ++k) {
    const std::uint64_t high = words[2 * k], low = words[2 * k + 1];
    const std::uint64_t upper = high * voxels, lower = low * voxels;  // voxels < 2^32
    const std::uint64_t sum = upper + (lower >> 32);
    voxel_[k] = std::uint32_t(sum >> 32);
    rest_[k] = double((sum << 32 | (lower & 0xFFFFFFFF)) >> 12) * scale;
  }
}

void SharedBounds::fetch(std::size_t size) const {
  for (std::size_t k = 0; k < size; ++k) {
    __builtin_prefetch(state_->count.data() + voxel_[k] * species_, 1);
    __builtin_prefetch(tables_->leave_rate.data() + voxel_[k] * species_);
    if (const JumpTable* const table = tables_->of_species[channels_[0].species].get()) table->prefetch(voxel_[k]);
  }
}

void SharedBounds::jump(std::uint32_t voxel, std::uint32_t species) {
  const JumpTable* const table = tables_->of_species[species].get();
  const std::uint32_t target =
      table ? table->target(voxel, targets_.take(1)[0]) : tables_->unlisted[species]->target(voxel, targets_);
  if (target == voxel) return;  // it fails
  --state_->count[voxel * species_ + species];
  ++happened_;
  if (target == voxels_->size()) {
    ++state_->ledger.counts[species].left;
    return;
  }
  ++state_->jump_events;
  arrive(target * species_ + species, species);
}

void SharedBounds::react(std::uint32_t voxel, int reaction) {
  ++happened_;
  const Reaction& law = network_.reactions()[std::size_t(reaction)];
  for (const Change& change : law.changes) {
    const std::size_t at = voxel * species_ + std::size_t(change.species);
    if (!network_.stochastic(change.species)) {
      state_->amount[at] += change.amount;
      continue;
    }
    state_->count[at] += change.amount - 1;
    arrive(at, std::uint32_t(change.species));
  }
}

void SharedBounds::arrive(std::size_t at, std::uint32_t species) {
  if (++state_->count[at] <= most_[species]) return;
  most_[species] = with_room(state_->count[at]);
  raised_ = true;
}

}  // namespace shmoo::rdme
