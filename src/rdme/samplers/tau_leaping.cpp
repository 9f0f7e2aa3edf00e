#include "rdme/samplers/tau_leaping.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "rdme/samplers/share_groups.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::uint32_t worth_threads = 2 * voxels_per_sequence;

}  // namespace

TauLeaping::TauLeaping(const Network& network, double tolerance) : network_(network), tolerance_(tolerance) {
  if (!(tolerance > 0 && tolerance < 1)) {
    throw base::InputError(fmt::format("the leap tolerance is {}; it must be between 0 and 1", tolerance));
  }
}

std::shared_ptr<const JumpTables> TauLeaping::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::uniform);
}

void TauLeaping::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = std::move(tables);
  for (auto& lane : lanes_) lane.bind(voxels, state);
  anything_moves_ = !tables_->entry_rate.empty() ||
                    std::ranges::any_of(tables_->of_species, [](const auto& table) { return table != nullptr; });
}

void TauLeaping::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  const Address address{key, step};
  const bool in_turns = process == Process::both && anything_moves_ && network_.any_sampled();
  if (process != Process::diffusion) react(t, in_turns ? 0.5 * dt : dt, address, 0);
  if (process != Process::reactions && anything_moves_) diffusion_.advance(*tables_, dt, address, *state_);
  if (in_turns) react(t + 0.5 * dt, 0.5 * dt, address, 1);
  for (auto& lane : lanes_) lane.close_books();
}

void TauLeaping::react(double t, double dt, const Address& address, std::uint32_t half) {
  if (!network_.any_sampled()) return;
  const auto voxels = static_cast<std::uint32_t>(voxels_->size());
  const auto threads = voxels < worth_threads ? std::size_t{1} : static_cast<std::size_t>(omp_get_max_threads());
  while (lanes_.size() < threads) {
    lanes_.emplace_back(network_, tolerance_);
    lanes_.back().bind(*voxels_, *state_);
  }
  const auto& windows = lanes_[0].propensities().windows(t, dt);
  share_groups(voxels, threads, [&](std::uint32_t begin, std::uint32_t end, std::size_t thread) {
    base::RandomSequence random(address.key, base::Stream::leaps, address.step, begin, half);
    for (std::uint32_t i = begin; i < end; ++i)
      for (const Window& window : windows) lanes_[thread].advance(i, window, random);
  });
}

}  // namespace shmoo::rdme
