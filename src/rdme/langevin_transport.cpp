#include "rdme/langevin_transport.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "rdme/samplers/share_groups.hpp"

namespace shmoo::rdme {

void LangevinTransport::bind(const Voxels& voxels, State& state) {
  voxels_ = &voxels;
  state_ = &state;
  pairs_.clear();
  gates_.clear();
  for (int s = 0; s < static_cast<int>(network_.species()); ++s) {
    if (network_.langevin(s) && voxels.graph_of_species[s] >= 0) add_pairs(s);
  }
  join_pairs();
  for (const Exchange& exchange : voxels.exchanges) {
    if (!network_.langevin(static_cast<int>(exchange.species))) continue;
    gates_.push_back({exchange.voxel, exchange.species, exchange.exit_rate, exchange.entry_rate});
  }
  std::vector<double> leave(voxels.size() * state.species, 0.0);
  const auto add = [&](std::uint32_t voxel, std::uint32_t species, double rate) {
    if (!(rate >= 0) || !std::isfinite(rate)) {
      throw base::RunError(fmt::format("species {} leaves voxel {} at the rate {} 1/s; it must be a finite number >= 0",
                                       network_.name(static_cast<int>(species)), voxel, rate));
    }
    leave[voxel * state.species + species] += rate;
  };
  for (const Pair& pair : pairs_) {
    add(pair.low, pair.species, pair.up);
    add(pair.high, pair.species, pair.down);
  }
  for (const Gate& gate : gates_) add(gate.voxel, gate.species, gate.exit);
  fastest_ = leave.empty() ? 0.0 : *std::ranges::max_element(leave);
}

void LangevinTransport::add_pairs(int species) {
  const JumpGraph& graph = voxels_->graphs[voxels_->graph_of_species[species]];
  const double kappa = network_.diffusivity(species);
  if (kappa == 0 && graph.flow.empty()) return;
  const auto s = static_cast<std::uint32_t>(species);
  for (std::uint32_t i = 0; i < voxels_->size(); ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      const std::uint32_t j = graph.target[p];
      const double rate = jump_rate(graph, p, kappa, voxels_->volume[i]);
      pairs_.push_back({std::min(i, j), std::max(i, j), s, i < j ? rate : 0.0, i < j ? 0.0 : rate, 0.0});
    }
  }
}

// Ascending by voxels and species, those of a lower voxel by themselves: pairs are many, and most of the order is
// there.
void LangevinTransport::sort_pairs() {
  std::vector<std::size_t> next(voxels_->size() + 1, 0);
  for (const Pair& pair : pairs_) ++next[pair.low + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<std::size_t> first = next;
  std::vector<Pair> sorted(pairs_.size());
  for (const Pair& pair : pairs_) sorted[next[pair.low]++] = pair;
  for (std::size_t i = 0; i < voxels_->size(); ++i)
    std::ranges::stable_sort(std::span(sorted).subspan(first[i], first[i + 1] - first[i]), {},
                             [](const Pair& pair) { return std::uint64_t{pair.high} << 32 | pair.species; });
  pairs_ = std::move(sorted);
}

// Both directions of a pair become one entry.
void LangevinTransport::join_pairs() {
  sort_pairs();
  const auto key = [](const Pair& pair) { return std::tuple{pair.low, pair.high, pair.species}; };
  std::size_t kept = 0;
  for (const Pair& pair : pairs_) {
    if (kept > 0 && key(pairs_[kept - 1]) == key(pair)) {
      pairs_[kept - 1].up += pair.up;
      pairs_[kept - 1].down += pair.down;
    } else {
      pairs_[kept++] = pair;
    }
  }
  pairs_.resize(kept);
}

void LangevinTransport::draw(double h, const StageAddress& address, std::span<const double> effective,
                             std::span<double> taken) {
  const std::size_t stride = state_->species;
  constexpr std::uint32_t group = voxels_per_sequence, gates = 1;  // no group begins at 1
  std::uint32_t now = 0;
  base::RandomSequence random(address.key, base::Stream::langevin_jumps, address.step, 0, address.stage);
  for (Pair& pair : pairs_) {
    if (pair.low / group != now) {
      now = pair.low / group;
      random = {address.key, base::Stream::langevin_jumps, address.step, now * group, address.stage};
    }
    const std::size_t low = pair.low * stride + pair.species, high = pair.high * stride + pair.species;
    const double up = pair.up * effective[low] * h, down = pair.down * effective[high] * h;
    pair.passes = up + down > 0 ? up - down + std::sqrt(up + down) * random.normal() : 0.0;
    taken[pair.passes > 0 ? low : high] += std::abs(pair.passes);
  }
  random = {address.key, base::Stream::langevin_jumps, address.step, gates, address.stage};
  for (Gate& gate : gates_) {
    const std::size_t at = gate.voxel * stride + gate.species;
    gate.leaves = smooth_number(gate.exit * effective[at] * h, random);
    gate.enters = smooth_number(gate.entry * h, random);
    taken[at] += std::max(0.0, gate.leaves) + std::max(0.0, -gate.enters);
  }
}

void LangevinTransport::apply(std::span<const double> share) {
  const std::size_t stride = state_->species;
  for (const Pair& pair : pairs_) {
    const std::size_t low = pair.low * stride + pair.species, high = pair.high * stride + pair.species;
    const double passes = pair.passes * share[pair.passes > 0 ? low : high];
    state_->amount[low] -= passes;
    state_->amount[high] += passes;
  }
  for (const Gate& gate : gates_) {
    const std::size_t at = gate.voxel * stride + gate.species;
    Account<double>& account = state_->ledger.amounts[gate.species];
    for (const double enters : {gate.enters, -gate.leaves}) {
      const double molecules = enters < 0 ? enters * share[at] : enters;
      state_->amount[at] += molecules;
      (molecules > 0 ? account.entered : account.left) += std::abs(molecules);
    }
  }
}

}  // namespace shmoo::rdme
