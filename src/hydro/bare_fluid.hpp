#pragma once
// Where kernels are never cut: forms of fourth order rest on moments of a whole support.
#include "scene/scene.hpp"

namespace shmoo::hydro {

// Whether fluid of one spacing fills the domain and meets nothing but itself and its images.
inline bool is_bare(const scene::Scene& scene) {
  for (std::size_t a = 0; a < std::size_t(scene.dimension); ++a)
    for (const auto& side : scene.domain.sides[a])
      if (scene::has_friction(side.type) || scene::is_open(side.type)) return false;
  for (const auto& material : scene.materials)
    if (material.type != scene::MaterialType::fluid) return false;
  return scene.domain.material >= 0 && scene.domain.refinements.empty();
}

}  // namespace shmoo::hydro
