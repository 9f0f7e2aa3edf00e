#pragma once
// What one realisation of the chemistry holds, and the ledger that accounts for every molecule of it.
#include <cstdint>
#include <string>
#include <vector>

#include "rdme/network.hpp"

namespace shmoo::rdme {

// Amounts of one species since the start. For a stochastic species all are whole numbers below 2^53 and the balance is
// exact.
template <class Number>
struct Account {
  Number initial{}, created{}, destroyed{}, entered{}, left{};
  Number expected() const { return initial + created - destroyed + entered - left; }
};

struct Ledger {
  std::vector<Account<std::int64_t>> counts;  // by species; used for stochastic species
  std::vector<Account<double>> amounts;       // by species; used for deterministic species
};

// Voxel-major: entry [voxel * species + s]. A stochastic species uses `count`, a deterministic one `amount`; both in
// molecules.
struct State {
  std::size_t species = 0;
  std::vector<std::int64_t> count;
  std::vector<double> amount;     // empty where no species is deterministic
  std::vector<double> parameter;  // SI, of those that events change, in the order of Network::varying()
  Ledger ledger;
  std::uint64_t reaction_events = 0;
  std::uint64_t jump_events = 0;  // moves from voxel to voxel; entries and exits are in the ledger
};

// No molecules anywhere.
State empty_state(const Network& network, std::size_t voxels);

// Molecules of a species in all voxels.
std::int64_t total_count(const State& state, int species);
double total_amount(const State& state, int species);

// Takes what is there now as what the ledger starts from.
void open_ledger(State& state, const Network& network);

// Does the ledger account for every molecule? Exact for counts, to `tolerance` of all that ever was there, or of a
// molecule, for amounts. Returns the empty string, or which species is off and by how much.
std::string imbalance(const State& state, const Network& network, double tolerance = 1e-9);

}  // namespace shmoo::rdme
