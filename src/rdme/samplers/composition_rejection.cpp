#include "rdme/samplers/composition_rejection.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {

CompositionRejection::CompositionRejection(const Network& network)
    : network_(network),
      propensities_(network),
      species_(network.species()),
      reactions_(network.reactions().size()),
      events_(reactions_, 0) {}

std::shared_ptr<const JumpTables> CompositionRejection::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::jumps);
}

void CompositionRejection::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = std::move(tables);
  propensities_.bind(voxels, state);
  table_.clear();
  for (const auto& table : tables_->of_species) table_.push_back(table.get());
  leave_ = tables_->leave_rate.data();
  entry_ = tables_->entry_rate.empty() ? nullptr : tables_->entry_rate.data();
  count_ = state.count.data();
  value_.assign(network_.any_sampled() ? voxels.size() * reactions_ : 0, 0.0);
  derived_ = false;
}

void CompositionRejection::derive_all() {
  groups_.clear(voxels_->size());
  for (std::uint32_t i = 0; i < voxels_->size(); ++i) {
    for (int r : network_.sampled_in(voxels_->material[i])) {
      value_[i * reactions_ + r] = reaction_ ? propensities_(r, i) : 0.0;
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
    for (std::size_t s = 0; s < species_; ++s) total += leave[s] * static_cast<double>(count[s]);
    for (std::size_t s = 0; entry_ && s < species_; ++s) total += entry_[voxel * species_ + s];
  }
  if (reaction_) {
    const double* const value = value_.data() + voxel * reactions_;
    for (int r : network_.sampled_in(voxels_->material[voxel])) total += value[r];
  }
  if (!(total < 0x1p1000)) {
    throw base::RunError(fmt::format("the rates in voxel {} add up to {} 1/s, which is no finite rate", voxel, total));
  }
  groups_.set(voxel, total);
}

void CompositionRejection::species_changed(std::uint32_t voxel, int species) {
  if (!reaction_) return;
  for (int r : network_.after_species(species)) {
    if (network_.reactions()[r].in_material[voxels_->material[voxel]])
      value_[voxel * reactions_ + r] = propensities_(r, voxel);
  }
}

void CompositionRejection::advance(double t, double dt, Process process, const base::RandomKey& key,
                                   std::uint64_t step) {
  propensities_.set_time(t + 0.5 * dt);
  if (process != process_ || network_.sampled_rates_change_in_time()) derived_ = false;
  process_ = process;
  diffusion_ = process != Process::reactions;
  reaction_ = process != Process::diffusion && network_.any_sampled();
  if (!derived_) derive_all();
  AttemptSequence sequence(key, base::Stream::stochastic_exact, step);
  Attempts attempts;
  double left = dt;
  while (left > 0 && groups_.sum() > 0) {
    sequence.next(attempts);
    prefetch(attempts);
    for (std::size_t k = 0; k < Attempts::size && groups_.sum() > 0; ++k) {
      left -= attempts.wait[k] / groups_.sum();
      if (left <= 0) break;
      const Groups::Pick pick = groups_.pick(attempts.choice[k]);
      if (pick.rest < groups_.total(pick.voxel)) fire(pick.voxel, pick.rest, attempts.word[k]);
    }
  }
  close_books();
}

// Where the coming attempts are likely to lead, as the groups stand now: has the memory bring it while others are at
// work.
void CompositionRejection::prefetch(const Attempts& attempts) const {
  const JumpTable* const table = species_ > 0 && diffusion_ ? table_[0] : nullptr;
  std::array<std::uint32_t, Attempts::size> voxel;
  for (std::size_t k = 0; k < Attempts::size; ++k) {
    voxel[k] = groups_.pick(attempts.choice[k]).voxel;
    groups_.prefetch(voxel[k]);
    __builtin_prefetch(count_ + voxel[k] * species_, 1);
    __builtin_prefetch(leave_ + voxel[k] * species_);
    if (table) table->prefetch(voxel[k]);
  }
  if (!table) return;
  for (std::size_t k = 0; k < Attempts::size; ++k) {
    const std::uint32_t target = table->empty(voxel[k]) ? voxel[k] : table->target(voxel[k], attempts.word[k]);
    if (target == voxels_->size()) continue;
    groups_.prefetch(target);
    __builtin_prefetch(count_ + target * species_, 1);
    __builtin_prefetch(leave_ + target * species_);
  }
}

void CompositionRejection::fire(std::uint32_t voxel, double rest, std::uint32_t word) {
  if (diffusion_) {
    const double* const leave = leave_ + voxel * species_;
    const std::int64_t* const count = count_ + voxel * species_;
    for (std::size_t s = 0; s < species_; ++s) {
      const double rate = leave[s] * static_cast<double>(count[s]);
      if (rest < rate) return jump(voxel, static_cast<int>(s), word);
      rest -= rate;
    }
    for (std::size_t s = 0; entry_ && s < species_; ++s) {
      const double rate = entry_[voxel * species_ + s];
      if (rest < rate) {
        ++count_[voxel * species_ + s];
        ++state_->ledger.counts[s].entered;
        species_changed(voxel, static_cast<int>(s));
        return refresh(voxel);
      }
      rest -= rate;
    }
  }
  if (!reaction_) return;  // round-off at the end of a sum: nothing happens
  for (int r : network_.sampled_in(voxels_->material[voxel])) {
    const double rate = value_[voxel * reactions_ + r];
    if (rest < rate) return react(voxel, r);
    rest -= rate;
  }
}

void CompositionRejection::jump(std::uint32_t voxel, int species, std::uint32_t word) {
  const std::uint32_t target = table_[species]->target(voxel, word);
  --count_[voxel * species_ + species];
  species_changed(voxel, species);
  refresh(voxel);
  if (target == voxels_->size()) {
    ++state_->ledger.counts[species].left;
    return;
  }
  ++count_[target * species_ + species];
  ++state_->jump_events;
  species_changed(target, species);
  refresh(target);
}

void CompositionRejection::react(std::uint32_t voxel, int reaction) {
  change_numbers(*state_, network_, network_.reactions()[reaction], voxel);
  ++events_[reaction];
  const std::uint16_t material = voxels_->material[voxel];
  for (int r : network_.after_reaction(reaction)) {
    if (network_.reactions()[r].in_material[material]) value_[voxel * reactions_ + r] = propensities_(r, voxel);
  }
  refresh(voxel);
}

void CompositionRejection::close_books() {
  for (std::size_t r = 0; r < reactions_; ++r) {
    if (events_[r] == 0) continue;
    book_reaction(state_->ledger, network_, network_.reactions()[r], events_[r]);
    state_->reaction_events += static_cast<std::uint64_t>(events_[r]);
    events_[r] = 0;
  }
}

}  // namespace shmoo::rdme
