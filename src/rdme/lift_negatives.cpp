// Amounts that an integration leaves below zero are given back what took too much of them.
#include <algorithm>
#include <cmath>
#include <limits>

#include "rdme/rate_system.hpp"

namespace shmoo::rdme {
namespace {

constexpr double round_off = 1e-12;
constexpr double almost_all = 1 - 1e-15;  // so that what gives does not itself become negative by round-off

}  // namespace

void RateSystem::lift_negatives(double* y) const {
  const std::size_t stride = species_.size();
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (std::size_t d = 0; d < stride; ++d) {
      if (y[i * stride + d] < 0) lift(i, d, y);
    }
  }
  for (std::size_t d = 0; d < stride; ++d) {
    if (rows_[d].graph) lift_by_all(d, y);
  }
}

// What is still below zero takes from all that is above, in proportion.
void RateSystem::lift_by_all(std::size_t place, double* y) const {
  const std::size_t stride = species_.size();
  double missing = 0, there = 0;
  for (std::size_t at = place; at < unknowns(); at += stride) (y[at] < 0 ? missing : there) += std::abs(y[at]);
  if (missing == 0 || missing > there) return;
  for (std::size_t at = place; at < unknowns(); at += stride) {
    y[at] = y[at] < 0 ? 0.0 : y[at] * (1 - missing / there);
  }
}

void RateSystem::lift(std::size_t voxel, std::size_t place, double* y) const {
  const std::size_t stride = species_.size(), at = voxel * stride + place;
  const int species = species_[place];
  double* const book = y + unknowns();
  for (const int r : network_.integrated_in(voxels_->material[voxel])) {  // fewer events
    if (y[at] >= 0) return;
    const auto& changes = network_.reactions()[r].changes;
    double events = 0, most = std::numeric_limits<double>::infinity();
    for (const Change& change : changes) {
      const double there = y[voxel * stride + place_of_[change.species]];
      if (change.species == species && change.amount < 0) events = y[at] / change.amount;
      if (change.amount > 0) most = std::min(most, std::max(0.0, there * almost_all) / change.amount);
    }
    if ((events = std::min(events, most)) <= 0) continue;
    const double before = y[at];
    add(r, voxel, -events, y);
    if (y[at] < 0 && y[at] > round_off * before) y[at] = 0;
  }
  const JumpGraph* const graph = rows_[place].graph;
  for (std::uint64_t p = graph ? graph->first[voxel] : 0; graph && p < graph->first[voxel + 1]; ++p) {  // fewer jumps
    if (y[at] >= 0) return;
    double& there = y[graph->target[p] * stride + place];
    const double back = std::min(std::max(0.0, there), -y[at]);
    there -= back;
    y[at] += back;
  }
  for (const Exchange& exchange : voxels_->exchanges) {  // fewer exits
    if (y[at] >= 0) return;
    if (exchange.voxel != voxel || place_of_[exchange.species] != int(place) || exchange.exit_rate <= 0) continue;
    book[left * stride + place] += y[at];
    y[at] = 0;
  }
}

}  // namespace shmoo::rdme
