#include <algorithm>
#include <limits>

#include "coupling/rules/limits.hpp"

namespace shmoo::coupling {
namespace {

constexpr double none = std::numeric_limits<double>::infinity();

// [m] Fluid ends at the outline; a wall has a bore where it keeps off the axis.
double narrowest_radius(const scene::PolygonShape& outline, bool fluid) {
  double least = none;
  for (const auto& corner : outline.corners) {
    if (corner[1] > 0.0) least = std::min(least, corner[1]);
    if (corner[1] == 0.0 && !fluid) return none;
  }
  return least;
}

double narrowest_radius(const scene::Shape& shape, bool fluid) {
  if (const auto* outline = std::get_if<scene::PolygonShape>(&shape.form)) return narrowest_radius(*outline, fluid);
  double least = none;
  if (const auto* all = std::get_if<scene::UnionShape>(&shape.form))
    for (const auto& part : all->parts) least = std::min(least, narrowest_radius(*part, fluid));
  if (const auto* difference = std::get_if<scene::DifferenceShape>(&shape.form))
    least = std::min(narrowest_radius(*difference->from, fluid), narrowest_radius(*difference->without, !fluid));
  return least;
}

}  // namespace

double narrowest_bore(const scene::Scene& scene) {
  double least = none;
  if (scene.dimension != 3) return least;
  for (const auto& region : scene.regions) {
    if (region.material < 0) continue;
    const bool fluid = scene.materials[std::size_t(region.material)].type == scene::MaterialType::fluid;
    least = std::min(least, 2.0 * narrowest_radius(*region.shape, fluid));
  }
  return least;
}

}  // namespace shmoo::coupling
