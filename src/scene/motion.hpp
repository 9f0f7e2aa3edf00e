#pragma once
// Whether anything of a scene moves.
#include <algorithm>

#include "scene/scene.hpp"

namespace shmoo::scene {

inline bool has_solids(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.type == MaterialType::solid; });
}

inline bool has_open_sides(const Scene& scene) {
  return std::any_of(scene.domain.sides.begin(), scene.domain.sides.end(),
                     [](const auto& axis) { return is_open(axis[0].type) || is_open(axis[1].type); });
}

inline bool has_mirrors(const Scene& scene) {
  const auto slips = [](const Side& side) { return side.type == SideType::slip; };
  return std::any_of(scene.domain.sides.begin(), scene.domain.sides.end(),
                     [&](const auto& axis) { return slips(axis[0]) || slips(axis[1]); });
}

// Whether species act back on what moves.
inline bool acts_back(const Scene& scene) {
  if (scene.effects.flow && !scene.flow.buoyancy.empty()) return true;
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.elastic && material.elastic->softening; });
}

inline bool quasi_static(const Scene& scene) { return scene.mechanics.motion == Motion::quasi_static; }

// Whether steps of time carry particles on: quasi-static walls go from equilibrium to equilibrium instead.
inline bool in_motion(const Scene& scene) { return scene.effects.flow || (has_solids(scene) && !quasi_static(scene)); }

}  // namespace shmoo::scene
