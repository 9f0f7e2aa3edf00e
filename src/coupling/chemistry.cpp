#include "coupling/chemistry.hpp"

#include <utility>

namespace shmoo::coupling {

Chemistry::Chemistry(const scene::Scene& scene, const rdme::Network& network, const base::RandomKey& key)
    : scene_(scene), network_(network), key_(key) {
  for (const auto& species : scene.species) {
    if (species.method == scene::SpeciesMethod::stochastic) {
      if (!sampler_) sampler_ = rdme::make_sampler(scene.numerics, network);
    } else if (species.method == scene::SpeciesMethod::langevin) {
      if (!langevin_) langevin_ = std::make_unique<rdme::LangevinSolver>(network, scene.numerics.leap_tolerance);
    } else if (!solver_) {
      solver_ = std::make_unique<rdme::DeterministicSolver>(network, scene.numerics.tolerance);
    }
  }
}

void Chemistry::begin(std::shared_ptr<const Ground> ground) {
  state_ = rdme::initial_state(scene_, network_, ground->voxels, key_);
  bind(std::move(ground));
}

void Chemistry::bind(std::shared_ptr<const Ground> ground) {
  if (ground == ground_) return;
  const auto before = std::exchange(ground_, std::move(ground));  // solvers look at it until they are bound anew
  if (sampler_) sampler_->bind(ground_->voxels, state_, ground_->tables);
  if (solver_) solver_->bind(ground_->voxels, state_);
  if (langevin_) langevin_->bind(ground_->voxels, state_);
}

void Chemistry::advance(std::shared_ptr<const Ground> ground, double t, double dt, std::uint64_t interval) {
  bind(std::move(ground));
  const int parts = (sampler_ ? 1 : 0) + (solver_ ? 1 : 0) + (langevin_ ? 1 : 0);
  const bool strang = scene_.numerics.splitting == scene::Splitting::strang && parts > 1;
  const double before = strang ? 0.5 * dt : dt, after = dt - before;
  if (solver_) solver_->advance(t, before, rdme::Process::both);
  if (langevin_) langevin_->advance(t, before, rdme::Process::both, key_, 2 * interval);
  if (sampler_) {
    if (parts > 1) sampler_->amounts_changed();
    sampler_->advance(t, dt, rdme::Process::both, key_, interval);
  }
  if (!strang) return;
  if (langevin_) langevin_->advance(t + before, after, rdme::Process::both, key_, 2 * interval + 1);
  if (solver_) solver_->advance(t + before, after, rdme::Process::both);
}

void Chemistry::pass(const std::vector<Passage>& passages, double volume, std::uint64_t interval) {
  for (const auto& passage : passages) {
    leave(passage.voxel);
    if (!passage.enters) continue;
    const auto& side = scene_.domain.sides[std::size_t(passage.side / 2)][std::size_t(passage.side % 2)];
    for (const auto& [species, concentration] : side.species) enter(passage, species, concentration * volume, interval);
  }
}

void Chemistry::leave(std::size_t voxel) {
  for (std::size_t s = 0; s < state_.species; ++s) {
    const std::size_t entry = voxel * state_.species + s;
    if (network_.stochastic(int(s))) {
      state_.ledger.counts[s].left += std::exchange(state_.count[entry], 0);
    } else {
      state_.ledger.amounts[s].left += std::exchange(state_.amount[entry], 0.0);
    }
  }
}

// Stochastic molecules are Poisson in number, as in any volume of a well-stirred reservoir.
void Chemistry::enter(const Passage& passage, int species, double molecules, std::uint64_t interval) {
  const auto s = std::size_t(species);
  const std::size_t entry = passage.voxel * state_.species + s;
  if (network_.stochastic(species)) {
    base::RandomSequence random(key_, base::Stream::entering, interval, passage.id, std::uint32_t(s));
    const auto count = base::poisson(random, molecules);
    state_.count[entry] += count;
    state_.ledger.counts[s].entered += count;
  } else {
    state_.amount[entry] += molecules;
    state_.ledger.amounts[s].entered += molecules;
  }
}

void Chemistry::close(Outcome& outcome) const {
  outcome.ledger = state_.ledger;
  outcome.balanced = rdme::imbalance(state_, network_).empty();
  outcome.reaction_events = state_.reaction_events;
  outcome.jump_events = state_.jump_events;
}

}  // namespace shmoo::coupling
