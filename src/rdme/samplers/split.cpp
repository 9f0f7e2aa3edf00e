#include "rdme/samplers/split.hpp"

#include "rdme/samplers/share_groups.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::uint32_t worth_threads = 8 * voxels_per_sequence;

}  // namespace

Split::Split(const Network& network) : network_(network) {}

std::shared_ptr<const JumpTables> Split::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::uniform);
}

void Split::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = std::move(tables);
  for (auto& lane : lanes_) lane.bind(voxels, state);
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
  for (auto& lane : lanes_) lane.close_books();
}

void Split::react(double t, double dt, const Address& address, std::uint32_t half) {
  if (!network_.any_sampled()) return;
  const auto voxels = static_cast<std::uint32_t>(voxels_->size());
  const auto threads = voxels < worth_threads ? std::size_t{1} : static_cast<std::size_t>(omp_get_max_threads());
  while (lanes_.size() < threads) {
    lanes_.emplace_back(network_);
    lanes_.back().bind(*voxels_, *state_);
  }
  const auto& windows = lanes_[0].propensities().windows(t, dt);
  share_groups(voxels, threads, [&](std::uint32_t begin, std::uint32_t end, std::size_t thread) {
    lanes_[thread].react(begin, end, windows, {address.key, base::Stream::voxel_reactions, address.step, begin, half});
  });
}

}  // namespace shmoo::rdme
