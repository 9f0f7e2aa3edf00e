#include "rdme/samplers/composition_rejection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "base/error.hpp"
#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::size_t near = 8192;            // voxels whose rows and rates the second cache holds
constexpr std::uint32_t of_targets = 4;       // place in the stream of exact events (shared_bounds.cpp has others)
constexpr std::uint32_t nobody = 0xFFFFFFFF;  // no voxel

}  // namespace

CompositionRejection::CompositionRejection(const Network& network)
    : network_(network),
      propensities_(network),
      species_(network.species()),
      reactions_(network.reactions().size()),
      shared_(network, propensities_),
      events_(reactions_, 0) {}

std::shared_ptr<const JumpTables> CompositionRejection::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::jumps);
}

void CompositionRejection::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) {
  voxels_ = &voxels;
  state_ = &state;
  propensities_.bind(voxels, state);
  use(std::move(tables));
  beside_ = Beside(network_.samples_surfaces() ? voxels.surfaces : std::vector<Surface>{}, voxels.size());
  count_ = state.count.data();
  far_ = voxels.size() > near;
  rows_.clear(network_.any_sampled() ? voxels.size() : 0, reactions_);
  amounts_changed();
}

void CompositionRejection::use(std::shared_ptr<const JumpTables> tables) {
  tables_ = std::move(tables);
  table_.clear();
  mobile_.clear();
  for (std::size_t s = 0; s < species_; ++s) {
    if (tables_->moves(s)) mobile_.push_back(static_cast<std::uint32_t>(s));
    table_.push_back(tables_->of_species[s].get());
  }
  leave_ = tables_->leave_rate.data();
  entry_ = tables_->entry_rate.empty() ? nullptr : tables_->entry_rate.data();
  shared_.bind(*voxels_, *state_, *tables_);
}

// Which way to go on. Where voxels were not alike, that is looked at again from time to time.
bool CompositionRejection::alike() {
  if (watch_ || network_.sampled_rates_change_in_time() || network_.samples_surfaces()) return false;
  const std::uint64_t events = state_->reaction_events + state_->jump_events;
  const bool again = way_ == Way::groups && events - decided_at_ > 8 * voxels_->size() + 100000;
  if (way_ == Way::undecided || again) {
    way_ = shared_.pays(process_) ? Way::shared_bounds : Way::groups;
    decided_at_ = events;
  }
  return way_ == Way::shared_bounds;
}

void CompositionRejection::derive_all() {
  groups_.clear(voxels_->size());
  for (std::uint32_t i = 0; i < voxels_->size(); ++i) {
    for (int r : network_.sampled_in(voxels_->material[i])) {
      rows_.set(i, std::size_t(r), reaction_ ? propensities_(r, i) : 0.0);
    }
    refresh(i);
  }
  derived_ = true;
}

void CompositionRejection::refresh(std::uint32_t voxel) {
  double total = 0;
  if (diffusion_) {
    const double* const leave = leave_ + voxel * species_;
    const std::int64_t* const count = count_ + voxel * species_;
    for (const std::uint32_t s : mobile_) total += leave[s] * static_cast<double>(count[s]);
    for (std::size_t s = 0; entry_ && s < species_; ++s) total += entry_[voxel * species_ + s];
  }
  if (reaction_) total += rows_.total(voxel);
  if (!(total < 0x1p1000)) {
    throw base::RunError(fmt::format("the rates in voxel {} add up to {} 1/s, which is no finite rate", voxel, total));
  }
  groups_.set(voxel, total);
}

void CompositionRejection::species_changed(std::uint32_t voxel, int species) {
  if (!reaction_) return;
  for (int r : network_.after_species(species, voxels_->material[voxel])) {
    rows_.set(voxel, std::size_t(r), propensities_(r, voxel));
  }
  for (const std::uint32_t beside : beside_.of(voxel)) {
    for (int r : network_.after_species(species, voxels_->material[beside]))
      rows_.set(beside, std::size_t(r), propensities_(r, beside));
    refresh(beside);
    wide_ = true;
  }
}

void CompositionRejection::advance(double t, double dt, Process process, const base::RandomKey& key,
                                   std::uint64_t step) {
  if (process != process_) amounts_changed();
  process_ = process;
  diffusion_ = process != Process::reactions;
  reaction_ = process != Process::diffusion && network_.any_sampled();
  if (auto better = with_rows_that_pay(tables_, network_, *voxels_, *state_, dt, Rows::jumps); better != tables_) {
    use(std::move(better));
    amounts_changed();
  }
  if (alike()) {
    derived_ = false;
    const double left = shared_.advance(dt, key, step, events_);
    t += dt - left;
    dt = left;
    if (left > 0) way_ = Way::groups;
  }
  if (dt > 0) by_groups(t, dt, key, step);
  close_books(*state_, network_, events_);
}

void CompositionRejection::by_groups(double t, double dt, const base::RandomKey& key, std::uint64_t step) {
  AttemptSequence sequence(key, base::Stream::stochastic_exact, step);
  targets_.open({key, base::Stream::stochastic_exact, step, of_targets});
  for (const Window& window : propensities_.windows(t, dt)) {
    propensities_.set_window(window);
    if (!derived_ || network_.sampled_rates_change_in_time()) derive_all();
    if (!pass(window, network_.sampled_rates_change_in_time() ? 0.0 : t, sequence)) break;
  }
}

// All events of a window whose times count from `origin`; false where the watch stops it.
bool CompositionRejection::pass(const Window& window, double origin, AttemptSequence& sequence) {
  Attempts attempts;
  Look look;
  end_ = window.to;
  for (double left = window.to - window.from; left > 0 && groups_.sum() > 0;) {
    if (look.from == 0) sequence.next(attempts);
    look_ahead(attempts, left, look);
    left = look.left[look.to - 1];
    look.from = look.to % Attempts::size;
    for (std::uint64_t bits = look.accepted; bits != 0; bits &= bits - 1) {
      const auto k = static_cast<std::size_t>(std::countr_zero(bits));
      const std::uint32_t voxel = std::exchange(look.voxel[k], nobody);
      left_ = look.left[k];
      const std::uint32_t other = fire(voxel, look.rest[k], attempts.word[k], look.target[k]);
      const bool wide = std::exchange(wide_, false);
      if (watch_ && watch_->stops(origin + end_ - left_)) return false;
      if (!wide && look.version == groups_.version() && !touched(look, voxel, other)) continue;
      left = look.left[k];
      look.from = (k + 1) % Attempts::size;
      break;
    }
  }
  return true;
}

// Picks, decisions and the memory that they will need. What lies beyond the end of the step is left out.
void CompositionRejection::look_ahead(const Attempts& attempts, double left, Look& look) {
  const JumpTable* const table = species_ > 0 && diffusion_ ? table_[0] : nullptr;
  const std::size_t window = std::clamp<std::size_t>(groups_.occupied() / 64, 1, 16);
  look.version = groups_.version();
  look.to = std::min(look.from + window, Attempts::size);
  look.accepted = 0;
  std::fill_n(look.voxel.begin(), look.from, nobody);
  const double mean = 1.0 / groups_.sum();
  groups_.pick(attempts.choice.data() + look.from, look.to - look.from, look.voxel.data() + look.from,
               look.rest.data() + look.from);
  std::fill(look.voxel.begin() + std::ptrdiff_t(look.to), look.voxel.end(), nobody);
  for (std::size_t k = look.from; k < look.to; ++k) look.left[k] = left -= attempts.wait[k] * mean;
  if (far_) fetch(look, table);
  for (std::size_t k = look.from; k < look.to; ++k) {
    const bool accepted = look.left[k] > 0 && look.rest[k] < groups_.total(look.voxel[k]);
    look.accepted |= std::uint64_t{accepted} << k;
  }
  for (std::uint64_t bits = table ? look.accepted : 0; bits != 0; bits &= bits - 1) {
    const auto k = static_cast<std::size_t>(std::countr_zero(bits));
    const std::uint32_t voxel = look.voxel[k];
    look.target[k] = table->empty(voxel) ? voxel : table->target(voxel, attempts.word[k]);
    if (!far_ || look.target[k] == voxels_->size()) continue;
    groups_.prefetch(look.target[k]);
    __builtin_prefetch(count_ + look.target[k] * species_, 1);
    __builtin_prefetch(leave_ + look.target[k] * species_);
  }
}

void CompositionRejection::fetch(const Look& look, const JumpTable* table) const {
  for (std::size_t k = look.from; k < look.to; ++k) {
    const std::uint32_t voxel = look.voxel[k];
    groups_.prefetch(voxel);
    __builtin_prefetch(count_ + voxel * species_, 1);
    __builtin_prefetch(leave_ + voxel * species_);
    if (table) table->prefetch(voxel);
  }
}

// Is one of the attempts that were looked at about one of two voxels?
bool CompositionRejection::touched(const Look& look, std::uint32_t voxel, std::uint32_t other) const {
  unsigned any = 0;
  for (std::uint32_t one : look.voxel) any |= static_cast<unsigned>(one == voxel) | static_cast<unsigned>(one == other);
  return any != 0;
}

// What an event of the voxel is, and its second voxel (or the same). `guess`: a jump's target by the first species'
// rows.
std::uint32_t CompositionRejection::fire(std::uint32_t voxel, double rest, std::uint32_t word, std::uint32_t guess) {
  if (diffusion_) {
    const double* const leave = leave_ + voxel * species_;
    const std::int64_t* const count = count_ + voxel * species_;
    for (const std::uint32_t s : mobile_) {
      const double rate = leave[s] * static_cast<double>(count[s]);
      if (rest < rate) {
        if (!table_[s]) return jump(voxel, static_cast<int>(s), tables_->unlisted[s]->target(voxel, targets_));
        return jump(voxel, static_cast<int>(s), table_[s] == table_[0] ? guess : table_[s]->target(voxel, word));
      }
      rest -= rate;
    }
    for (std::size_t s = 0; entry_ && s < species_; ++s) {
      const double rate = entry_[voxel * species_ + s];
      if (rest < rate) {
        ++count_[voxel * species_ + s];
        ++state_->ledger.counts[s].entered;
        species_changed(voxel, static_cast<int>(s));
        refresh(voxel);
        return voxel;
      }
      rest -= rate;
    }
  }
  if (!reaction_) return voxel;  // round-off at the end of a sum: nothing happens
  const std::size_t reaction = rows_.pick(voxel, rest);
  return reaction < reactions_ ? react(voxel, static_cast<int>(reaction), rest) : voxel;
}

std::uint32_t CompositionRejection::jump(std::uint32_t voxel, int species, std::uint32_t target) {
  if (target == voxel) return voxel;  // it fails
  --count_[voxel * species_ + species];
  species_changed(voxel, species);
  refresh(voxel);
  if (target == voxels_->size()) {
    ++state_->ledger.counts[species].left;
    return voxel;
  }
  ++count_[target * species_ + species];
  ++state_->jump_events;
  species_changed(target, species);
  refresh(target);
  return target;
}

// `rest` is uniform below the reaction's propensity.
std::uint32_t CompositionRejection::react(std::uint32_t voxel, int index, double rest) {
  const double bound = rows_.value(voxel, std::size_t(index));
  if (!propensities_.happens(index, voxel, end_ - left_, rest, bound)) return voxel;
  const auto partner = static_cast<std::uint32_t>(propensities_.partner(index, voxel, rest));
  const Reaction& reaction = network_.reactions()[index];
  change_numbers(*state_, network_, reaction, voxel, partner);
  ++events_[index];
  if (beside_.any()) {
    for (const Change& change : reaction.changes) species_changed(change.beyond ? partner : voxel, change.species);
    refresh(partner);
    refresh(voxel);
    return partner;
  }
  for (int r : network_.after_reaction(index, voxels_->material[voxel])) {
    rows_.set(voxel, std::size_t(r), propensities_(r, voxel));
  }
  refresh(voxel);
  return voxel;
}

}  // namespace shmoo::rdme
