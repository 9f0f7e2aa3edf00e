#include "rdme/state.hpp"

#include <fmt/format.h>

#include <cmath>

namespace shmoo::rdme {

State empty_state(const Network& network, std::size_t voxels) {
  State state;
  state.species = network.species();
  state.count.assign(voxels * state.species, 0);
  if (network.any_smooth()) state.amount.assign(voxels * state.species, 0.0);
  for (const int varying : network.varying())
    state.parameter.push_back(network.parameters()[static_cast<std::size_t>(varying)].second);
  state.ledger.counts.resize(state.species);
  state.ledger.amounts.resize(state.species);
  return state;
}

std::int64_t total_count(const State& state, int species) {
  std::int64_t total = 0;
  for (std::size_t i = species; i < state.count.size(); i += state.species) total += state.count[i];
  return total;
}

double total_amount(const State& state, int species) {
  double total = 0;
  for (std::size_t i = species; i < state.amount.size(); i += state.species) total += state.amount[i];
  return total;
}

void open_ledger(State& state, const Network& network) {
  for (std::size_t s = 0; s < state.species; ++s) {
    const int species = static_cast<int>(s);
    state.ledger.counts[s] = {};
    state.ledger.amounts[s] = {};
    if (network.stochastic(species)) {
      state.ledger.counts[s].initial = total_count(state, species);
    } else {
      state.ledger.amounts[s].initial = total_amount(state, species);
    }
  }
}

std::string imbalance(const State& state, const Network& network, double tolerance) {
  for (std::size_t s = 0; s < state.species; ++s) {
    const int species = static_cast<int>(s);
    if (network.stochastic(species)) {
      const std::int64_t found = total_count(state, species), expected = state.ledger.counts[s].expected();
      if (found != expected) {
        return fmt::format("{}: {} molecules found, {} expected by the ledger", network.name(species), found, expected);
      }
      continue;
    }
    const Account<double>& account = state.ledger.amounts[s];
    const double found = total_amount(state, species), expected = account.expected();
    const double handled = 1.0 + std::abs(account.initial) + std::abs(account.created) + std::abs(account.destroyed) +
                           account.entered + std::abs(account.left);
    if (!(std::abs(found - expected) <= tolerance * handled)) {
      return fmt::format("{}: {} molecules found, {} expected by the ledger, off by {} of all that was handled",
                         network.name(species), found, expected, std::abs(found - expected) / handled);
    }
  }
  return {};
}

}  // namespace shmoo::rdme
