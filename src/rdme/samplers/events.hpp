#pragma once
// What one event changes, in the state and in the ledger.
#include "rdme/network.hpp"
#include "rdme/state.hpp"

namespace shmoo::rdme {

// `times` equal events of a reaction: what the ledger has to know. Net changes are booked.
inline void book_reaction(Ledger& ledger, const Network& network, const Reaction& reaction, std::int64_t times) {
  for (const Change& change : reaction.changes) {
    const std::int64_t molecules = times * (change.amount > 0 ? change.amount : -change.amount);
    if (network.stochastic(change.species)) {
      Account<std::int64_t>& account = ledger.counts[change.species];
      (change.amount > 0 ? account.created : account.destroyed) += molecules;
    } else {
      Account<double>& account = ledger.amounts[change.species];
      (change.amount > 0 ? account.created : account.destroyed) += static_cast<double>(molecules);
    }
  }
}

// Books events that were counted by reaction, and counts anew.
inline void close_books(State& state, const Network& network, std::vector<std::int64_t>& events) {
  for (std::size_t r = 0; r < events.size(); ++r) {
    if (events[r] == 0) continue;
    book_reaction(state.ledger, network, network.reactions()[r], events[r]);
    state.reaction_events += static_cast<std::uint64_t>(events[r]);
    events[r] = 0;
  }
}

// One event of a reaction in a voxel and, on a surface, its partner; the ledger is left alone.
inline void change_numbers(State& state, const Network& network, const Reaction& reaction, std::size_t voxel,
                           std::size_t partner) {
  for (const Change& change : reaction.changes) {
    const std::size_t at = (change.beyond ? partner : voxel) * state.species + change.species;
    if (network.stochastic(change.species)) {
      state.count[at] += change.amount;
    } else {
      state.amount[at] += change.amount;
    }
  }
}

// The same of a reaction that is not on a surface.
inline void change_numbers(State& state, const Network& network, const Reaction& reaction, std::size_t voxel) {
  change_numbers(state, network, reaction, voxel, voxel);
}

}  // namespace shmoo::rdme
