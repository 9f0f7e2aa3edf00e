#include "rdme/samplers/tau_leaping.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::uint32_t worth_threads = 2 * voxels_per_sequence;

}  // namespace

TauLeaping::TauLeaping(const Network& network, double tolerance)
    : network_(network),
      reactions_([&network, tolerance] { return LeapingReactions(network, tolerance); }, worth_threads) {
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
  reactions_.bind(voxels, state);
  anything_moves_ = !tables_->entry_rate.empty();
  for (std::size_t s = 0; s < network_.species(); ++s) anything_moves_ = anything_moves_ || tables_->moves(s);
}

void TauLeaping::advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) {
  const Address address{key, step};
  if (process != Process::reactions)
    tables_ = with_rows_that_pay(tables_, network_, *voxels_, *state_, dt, Rows::uniform);
  const bool in_turns = process == Process::both && anything_moves_ && network_.any_sampled();
  if (process != Process::diffusion) react(t, in_turns ? 0.5 * dt : dt, address, 0);
  if (process != Process::reactions && anything_moves_) diffusion_.advance(*tables_, dt, address, *state_);
  if (in_turns) react(t + 0.5 * dt, 0.5 * dt, address, 1);
  reactions_.close_books();
}

void TauLeaping::react(double t, double dt, const Address& address, std::uint32_t half) {
  if (!network_.any_sampled()) return;
  reactions_.advance(t, dt, [&](LeapingReactions& one, std::uint32_t begin, std::uint32_t end, const auto& windows) {
    base::RandomSequence random(address.key, base::Stream::leaps, address.step, begin, half);
    for (std::uint32_t i = begin; i < end; ++i)
      for (const Window& window : windows) one.advance(i, window, random);
  });
}

}  // namespace shmoo::rdme
