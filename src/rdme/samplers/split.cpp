#include "rdme/samplers/split.hpp"

#include <algorithm>

#include "rdme/samplers/events.hpp"

namespace shmoo::rdme {
Split::Split(const Network& network)
    : network_(network),
      propensities_(network),
      value_(network.reactions().size(), 0.0),
      events_(network.reactions().size(), 0) {}

std::shared_ptr<const JumpTables> Split::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::uniform);
}

void Split::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = std::move(tables);
  propensities_.bind(voxels, state);
}

void Split::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  const Address address{key, step};
  if (process == Process::reactions) react(t, dt, address, 0);
  if (process == Process::diffusion) diffusion_.advance(*tables_, dt, address, *state_);
  if (process == Process::both) {
    react(t, 0.5 * dt, address, 0);
    diffusion_.advance(*tables_, dt, address, *state_);
    react(t + 0.5 * dt, 0.5 * dt, address, 1);
  }
  for (std::size_t r = 0; r < events_.size(); ++r) {
    book_reaction(state_->ledger, network_, network_.reactions()[r], events_[r]);
    state_->reaction_events += static_cast<std::uint64_t>(events_[r]);
    events_[r] = 0;
  }
}

void Split::react(double t, double dt, const Address& address, std::uint32_t half) {
  if (!network_.any_sampled()) return;
  const auto& windows = propensities_.windows(t, dt);
  const auto size = static_cast<std::uint32_t>(voxels_->size());
  for (std::uint32_t begin = 0; begin < size; begin += voxels_per_sequence) {
    base::RandomSequence random(address.key, base::Stream::voxel_reactions, address.step, begin, half);
    for (std::uint32_t i = begin; i < std::min(size, begin + voxels_per_sequence); ++i) {
      for (const Window& window : windows) react(i, window, random);
    }
  }
}

void Split::react(std::uint32_t voxel, const Window& window, base::RandomSequence& random) {
  const std::uint16_t material = voxels_->material[voxel];
  const std::span<const int> running = network_.sampled_in(material);
  propensities_.set_window(window);
  double sum = 0;
  for (int r : running) sum += value_[r] = propensities_(r, voxel);
  for (double left = window.to - window.from; sum > 0 && (left -= random.exponential() / sum) > 0;) {
    double rest = random.uniform() * sum;
    int fires = -1;
    for (int r : running) {
      if (value_[r] <= 0) continue;
      fires = r;
      if (rest < value_[r]) break;
      rest -= value_[r];
    }
    if (!propensities_.happens(fires, voxel, window.to - left, rest, value_[fires])) continue;
    change_numbers(*state_, network_, network_.reactions()[fires], voxel);
    ++events_[fires];
    for (int r : network_.after_reaction(fires, material)) value_[r] = propensities_(r, voxel);
    sum = 0;
    for (int r : running) sum += value_[r];
  }
}

}  // namespace shmoo::rdme
