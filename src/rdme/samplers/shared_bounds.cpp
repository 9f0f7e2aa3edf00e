#include "rdme/samplers/shared_bounds.hpp"

#include <algorithm>
#include <boost/random/beta_distribution.hpp>
#include <cmath>

#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {
namespace {

constexpr double least_share = 0.1;             // of attempts that must be events
constexpr std::size_t most_channels = 32;       // looked at one by one
constexpr int most_order = 16;                  // of a reaction
constexpr std::size_t near = 8192;              // voxels that the second cache holds
constexpr std::uint64_t most_at_once = 1 << 20;  // attempts of one Poisson number, about

// Places of the stream of exact events; 0 is taken by groups of voxels, 4 by where their molecules jump.
constexpr std::uint32_t of_numbers = 1, of_targets = 2, of_attempts = 3;

// Mass action of whole molecules within a voxel.
bool plain(const Network& network, const Reaction& reaction) {
  return reaction.expression.empty() && !reaction.on_surface() && reaction.order <= most_order &&
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
  possible_ = species_ > 0 && network.varying().empty() &&
              std::ranges::all_of(network.reactions(),
                                  [&](const Reaction& r) { return !sampled(r) || plain(network, r); }) &&
              species_ + std::size_t(std::ranges::count_if(network.reactions(), sampled)) <= most_channels;
}

void SharedBounds::bind(const Voxels& voxels, State& state, const JumpTables& tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = &tables;
  fastest_.assign(species_, 0.0);
  for (std::size_t at = 0; at < tables.leave_rate.size(); at += species_)
    for (std::size_t s = 0; s < species_; ++s) fastest_[s] = std::max(fastest_[s], tables.leave_rate[at + s]);
  const auto [least, largest] = std::ranges::minmax_element(voxels.volume);
  volume_factor_.clear();
  for (int order = 0; voxels.size() > 0 && order <= most_order; ++order)
    volume_factor_.push_back(std::max(std::pow(*least, 1 - order), std::pow(*largest, 1 - order)));
}

double SharedBounds::constant(std::size_t reaction) const {
  const Reaction& law = network_.reactions()[reaction];
  double product = law.rate_constant * volume_factor_.at(std::size_t(law.order));
  for (const auto& term : law.reactants)
    product *= falling_power(double(most_[std::size_t(term.species)]), term.count);
  return product * (1 + 1e-12);
}

// The material of vacant voxels is beyond all others.
bool SharedBounds::runs(int reaction, std::size_t voxel) const {
  const auto& in_material = network_.reactions()[std::size_t(reaction)].in_material;
  const std::size_t material = voxels_->material[voxel];
  return material < in_material.size() && in_material[material];
}

void SharedBounds::add_channels(Process process) {
  process_ = process;
  jumping_.clear();
  reacting_.clear();
  for (std::uint32_t s = 0; process != Process::reactions && s < species_; ++s)
    if (tables_->moves(s)) jumping_.push_back(s);
  for (std::size_t r = 0; process != Process::diffusion && r < network_.reactions().size(); ++r)
    if (network_.reactions()[r].treatment() == Treatment::sampled) reacting_.push_back(int(r));
}

void SharedBounds::sum_bounds() {
  below_.assign(1, 0.0);
  for (const std::uint32_t s : jumping_) below_.push_back(below_.back() + fastest_[s] * double(most_[s]));
  for (const int r : reacting_) below_.push_back(below_.back() + constant(std::size_t(r)));
}

double SharedBounds::rates() const {
  double sum = 0.0;
  for (const std::uint32_t s : jumping_) {
    for (std::size_t at = s; at < state_->count.size(); at += species_)
      sum += tables_->leave_rate[at] * double(state_->count[at]);
  }
  for (const int r : reacting_)
    for (std::size_t i = 0; i < voxels_->size(); ++i)
      if (runs(r, i)) sum += propensities_(r, i);
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
  for (std::uint64_t made = 0; made < number; made += batch) {
    const auto size = std::size_t(std::min<std::uint64_t>(number - made, batch));
    draw(size);
    if (far) fetch(size);
    for (std::size_t k = 0; k < size; ++k) {
      attempt(voxel_[k], rest_[k], events);
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
    if (!jumping_.empty() && tables_->of_species[jumping_[0]]) tables_->of_species[jumping_[0]]->prefetch(voxel_[k]);
  }
}

void SharedBounds::attempt(std::uint32_t voxel, double rest, std::vector<std::int64_t>& events) {
  std::size_t channel = 0;
  for (std::size_t c = 1; c + 1 < below_.size(); ++c) channel += rest >= below_[c] ? 1U : 0U;
  rest -= below_[channel];
  if (channel < jumping_.size()) {
    const std::uint32_t s = jumping_[channel];
    const std::size_t at = voxel * species_ + s;
    if (rest < tables_->leave_rate[at] * double(state_->count[at])) jump(voxel, s);
    return;
  }
  const int reaction = reacting_[channel - jumping_.size()];
  if (!runs(reaction, voxel) || rest >= propensities_(reaction, voxel)) return;
  react(voxel, reaction);
  ++events[std::size_t(reaction)];
}

void SharedBounds::jump(std::uint32_t voxel, std::uint32_t species) {
  const JumpTable* const table = tables_->of_species[species].get();
  const std::uint32_t target = table ? table->target(voxel, targets_.take(1)[0])
                                     : tables_->unlisted[species]->target(voxel, targets_);
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
