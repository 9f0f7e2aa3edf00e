#include "hydro/effects/buoyancy.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::hydro {

double largest_lightness(const scene::Scene& scene) {
  double sum = 0.0;
  for (const auto& buoyancy : scene.flow.buoyancy) {
    double largest = std::abs(buoyancy.reference);  // where there is none of it
    const auto offer = [&](int species, double C) {
      if (species == buoyancy.species) largest = std::max(largest, std::abs(C - buoyancy.reference));
    };
    for (const auto& initial : scene.initials) offer(initial.species, initial.concentration.value);
    for (const auto& boundary : scene.boundaries) {
      if (boundary.type == scene::BoundaryType::fixed) offer(boundary.species, boundary.value);
    }
    for (const auto& inflow : scene.inflows) {
      for (const auto& [species, target] : inflow.species) offer(species, target);
    }
    sum += std::abs(buoyancy.expansion) * largest;
  }
  return sum;
}

}  // namespace shmoo::hydro
