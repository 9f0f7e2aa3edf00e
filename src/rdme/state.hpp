#pragma once
// What one realisation of the chemistry holds, and the ledger that accounts for every molecule of it.
#include <cstdint>
#include <vector>

namespace shmoo::rdme {

// Amounts of one species since the start. For a stochastic species all are whole numbers below 2^53 and the balance is exact.
template <class Number>
struct Account {
  Number initial{}, created{}, destroyed{}, entered{}, left{};
  Number expected() const { return initial + created - destroyed + entered - left; }
};

struct Ledger {
  std::vector<Account<std::int64_t>> counts;  // by species; used for stochastic species
  std::vector<Account<double>> amounts;       // by species; used for deterministic species
};

// Voxel-major: entry [voxel * species + s]. A stochastic species uses `count`, a deterministic one `amount`; both in molecules.
struct State {
  std::size_t species = 0;
  std::vector<std::int64_t> count;
  std::vector<double> amount;  // empty where no species is deterministic
  Ledger ledger;
  std::uint64_t reaction_events = 0;
  std::uint64_t jump_events = 0;
};

}  // namespace shmoo::rdme
