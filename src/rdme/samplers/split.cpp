#include "rdme/samplers/split.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::uint32_t worth_threads = 8 * voxels_per_sequence;

}  // namespace

Split::Split(const Network& network)
    : network_(network), reactions_([&network] { return VoxelReactions(network); }, worth_threads) {}

std::shared_ptr<const JumpTables> Split::prepare(const Voxels& voxels) const {
  return make_jump_tables(network_, voxels, Rows::uniform);
}

void Split::bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) {
  voxels_ = &voxels;
  state_ = &state;
  tables_ = std::move(tables);
  reactions_.bind(voxels, state);
}

void Split::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  const Address address{key, step};
  if (process != Process::reactions)
    tables_ = with_rows_that_pay(tables_, network_, *voxels_, *state_, dt, Rows::uniform);
  if (process == Process::reactions) react(t, dt, address, 0);
  if (process == Process::diffusion) diffusion_.advance(*tables_, dt, address, *state_);
  if (process == Process::both) {
    react(t, 0.5 * dt, address, 0);
    diffusion_.advance(*tables_, dt, address, *state_);
    react(t + 0.5 * dt, 0.5 * dt, address, 1);
  }
  reactions_.close_books();
}

void Split::react(double t, double dt, const Address& address, std::uint32_t half) {
  if (!network_.any_sampled()) return;
  reactions_.advance(t, dt, [&](VoxelReactions& one, std::uint32_t begin, std::uint32_t end, const auto& windows) {
    one.react(begin, end, windows, {address.key, base::Stream::voxel_reactions, address.step, begin, half});
  });
}

}  // namespace shmoo::rdme
