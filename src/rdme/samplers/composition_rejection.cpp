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
    const double* const leave = tables_->leave_rate.data() + voxel * species_;
    const std::int64_t* const count = state_->count.data() + voxel * species_;
    for (std::size_t s = 0; s < species_; ++s) total += leave[s] * static_cast<double>(count[s]);
    if (!tables_->entry_rate.empty()) {
      for (std::size_t s = 0; s < species_; ++s) total += tables_->entry_rate[voxel * species_ + s];
    }
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
  Words words(key, base::Stream::stochastic_exact, step);
  propensities_.set_time(t + 0.5 * dt);
  if (process != process_ || network_.sampled_rates_change_in_time()) derived_ = false;
  process_ = process;
  diffusion_ = process != Process::reactions;
  reaction_ = process != Process::diffusion && network_.any_sampled();
  if (!derived_) derive_all();
  double left = dt;
  while (groups_.sum() > 0 && (left -= words.exponential() / groups_.sum()) > 0) {
    const Groups::Pick pick = groups_.pick(words.uniform());
    if (pick.rest < groups_.total(pick.voxel)) fire(pick.voxel, pick.rest, words);
  }
  close_books();
}

void CompositionRejection::fire(std::uint32_t voxel, double rest, Words& words) {
  if (diffusion_) {
    const double* const leave = tables_->leave_rate.data() + voxel * species_;
    const std::int64_t* const count = state_->count.data() + voxel * species_;
    for (std::size_t s = 0; s < species_; ++s) {
      const double rate = leave[s] * static_cast<double>(count[s]);
      if (rest < rate) return jump(voxel, static_cast<int>(s), words.word());
      rest -= rate;
    }
    for (std::size_t s = 0; !tables_->entry_rate.empty() && s < species_; ++s) {
      const double rate = tables_->entry_rate[voxel * species_ + s];
      if (rest < rate) {
        ++state_->count[voxel * species_ + s];
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
  const std::uint32_t target = tables_->of_species[species]->target(voxel, word);
  --state_->count[voxel * species_ + species];
  species_changed(voxel, species);
  refresh(voxel);
  if (target == voxels_->size()) {
    ++state_->ledger.counts[species].left;
    return;
  }
  ++state_->count[target * species_ + species];
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
