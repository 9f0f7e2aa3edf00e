// Integrated reactions on surfaces (pair_law.hpp), with their derivatives.
#include <cstdlib>

#include "rdme/rate_system.hpp"
#include "rdme/surface/pair_law.hpp"

namespace shmoo::rdme {

// Events per second of the pair and, where a direction is given, their change along it.
RateSystem::PairRate RateSystem::pair_rate(const Law& law, double coefficient, std::size_t voxel, std::size_t other,
                                           const double* y, const double* direction) const {
  PairRate rate{coefficient, 0.0};
  int negative = 0;
  for (std::uint32_t f = law.first; f < law.last; ++f) {
    const Factor& factor = laws_.factors[f];
    const std::size_t at = factor.beyond ? other : voxel;
    if (factor.stochastic) {
      const double n = falling(state_->count[at * state_->species + std::size_t(factor.species)], factor.count);
      rate.value *= n;
      rate.slope *= n;
      continue;
    }
    const std::size_t place = at * species_.size() + std::size_t(place_of_[std::size_t(factor.species)]);
    if (y[place] < 0) negative += factor.count;
    for (int k = 0; k < factor.count; ++k) {
      rate.slope = rate.slope * y[place] + (direction ? rate.value * direction[place] : 0.0);
      rate.value *= y[place];
    }
  }
  if (negative > 0 && negative % 2 == 0) return {-rate.value, -rate.slope};  // as in turn()
  return rate;
}

void RateSystem::add_surfaces(const double* y, const double* direction, double* dy) const {
  for (const int r : network_.integrated_on_surfaces()) {
    const Reaction& reaction = network_.reactions()[std::size_t(r)];
    const Surface* const surface = voxels_->surface(reaction.surface);
    const Law& law = laws_.of_reaction[std::size_t(r)];
    for (std::size_t i = 0; surface && i < voxels_->size(); ++i) {
      for (std::uint64_t p = surface->first[i]; p < surface->first[i + 1]; ++p) {
        const std::size_t j = surface->target[p];
        const double k = pair_coefficient(law, *surface, p, voxels_->volume[i], voxels_->volume[j]);
        const PairRate rate = pair_rate(law, k, i, j, y, direction);
        add(reaction, i, j, direction ? rate.slope : rate.value, dy);
      }
    }
  }
}

// How the events of a pair change with each amount that they read.
void RateSystem::pair_entries(const Reaction& reaction, const Law& law, double k, std::size_t i, std::size_t j,
                              const double* y, std::vector<Entry>& entries) {
  const std::size_t stride = species_.size();
  for (std::uint32_t f = law.first; f < law.last; ++f) {
    const Factor& factor = laws_.factors[f];
    if (factor.stochastic) continue;
    const auto column = (factor.beyond ? j : i) * stride + std::size_t(place_of_[std::size_t(factor.species)]);
    direction_[column] = 1.0;
    const double slope = y ? pair_rate(law, k, i, j, y, direction_.data()).slope : 0.0;
    direction_[column] = 0.0;
    for (const Change& change : reaction.changes) {
      const auto d = std::size_t(place_of_[std::size_t(change.species)]);
      const auto row = (change.beyond ? j : i) * stride + d;
      const auto book = unknowns() + (change.amount > 0 ? created : destroyed) * stride + d;
      entries.push_back({std::uint32_t(row), std::uint32_t(column), change.amount * slope});
      entries.push_back({std::uint32_t(book), std::uint32_t(column), std::abs(change.amount) * slope});
    }
  }
}

void RateSystem::surface_entries(const double* y, std::vector<Entry>& entries) {
  for (const int r : network_.integrated_on_surfaces()) {
    const Reaction& reaction = network_.reactions()[std::size_t(r)];
    const Surface* const surface = voxels_->surface(reaction.surface);
    const Law& law = laws_.of_reaction[std::size_t(r)];
    for (std::size_t i = 0; surface && i < voxels_->size(); ++i) {
      for (std::uint64_t p = surface->first[i]; p < surface->first[i + 1]; ++p) {
        const std::size_t j = surface->target[p];
        const double k = pair_coefficient(law, *surface, p, voxels_->volume[i], voxels_->volume[j]);
        pair_entries(reaction, law, k, i, j, y, entries);
      }
    }
  }
}

}  // namespace shmoo::rdme
