// Propensities of reactions on surfaces (pair_law.hpp). To a sampler such a reaction is one of its voxel of the first
// material, summed over neighbours; which neighbour takes part is asked when it happens.
#include <fmt/format.h>

#include "base/error.hpp"
#include "rdme/propensity.hpp"
#include "rdme/surface/pair_law.hpp"

namespace shmoo::rdme {

void Propensities::bind_surfaces() {
  surface_of_.assign(laws_.of_reaction.size(), nullptr);
  for (std::size_t r = 0; r < surface_of_.size(); ++r)
    if (laws_.of_reaction[r].surface) surface_of_[r] = voxels_->surface(network_.reactions()[r].surface);
}

// prod n (n-1) ... (n-nu+1) over the reactants on one side, as in available().
double Propensities::available(const Law& law, std::size_t voxel, bool beyond) const {
  double product = 1.0;
  for (std::uint32_t f = law.first; f < law.last; ++f) {
    const Factor& factor = laws_.factors[f];
    if (factor.beyond != beyond) continue;
    const std::size_t at = voxel * species_ + std::size_t(factor.species);
    if (factor.stochastic) {
      product *= falling(count_[at], factor.count);
      continue;
    }
    const double n = amount_[at] > 0.0 ? amount_[at] : 0.0;
    if (n < factor.taken) return 0.0;
    for (int k = 0; k < factor.count; ++k) product *= n;
  }
  return product;
}

double Propensities::on_pair(const Law& law, const Surface& surface, std::uint64_t pair, std::size_t voxel) const {
  const std::size_t other = surface.target[pair];
  return pair_coefficient(law, surface, pair, volume_[voxel], volume_[other]) * available(law, other, true);
}

double Propensities::on_surface(int reaction, std::size_t voxel) {
  const Law& law = laws_.of_reaction[std::size_t(reaction)];
  const Surface* const surface = surface_of_[std::size_t(reaction)];
  const double own = available(law, voxel, false);
  if (!surface || own == 0.0) return 0.0;
  double sum = 0.0;
  for (std::uint64_t p = surface->first[voxel]; p < surface->first[voxel + 1]; ++p)
    sum += on_pair(law, *surface, p, voxel);
  const double a = own * sum;
  if (!(a >= 0.0 && a <= 1e300)) refuse(reaction, voxel, a, time_);
  return a;
}

std::size_t Propensities::partner(int reaction, std::size_t voxel, double rest) const {
  const Law& law = laws_.of_reaction[std::size_t(reaction)];
  if (!law.surface) return voxel;
  const Surface& surface = *surface_of_[std::size_t(reaction)];
  const double own = available(law, voxel, false);
  std::size_t last = voxel;
  for (std::uint64_t p = surface.first[voxel]; p < surface.first[voxel + 1]; ++p) {
    const double a = own * on_pair(law, surface, p, voxel);
    if (a <= 0.0) continue;
    last = surface.target[p];
    if (rest < a) break;
    rest -= a;  // round-off at the end of the sum stays with the last that can
  }
  return last;
}

}  // namespace shmoo::rdme
