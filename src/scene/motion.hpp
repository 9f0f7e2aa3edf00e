#pragma once
// Whether anything of a scene moves.
#include <algorithm>

#include "scene/scene.hpp"

namespace shmoo::scene {

inline bool has_solids(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.type == MaterialType::solid; });
}

// Whether species act back on what moves.
inline bool acts_back(const Scene& scene) {
  if (scene.effects.flow && !scene.flow.buoyancy.empty()) return true;
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.elastic && material.elastic->softening; });
}

inline bool in_motion(const Scene& scene) { return scene.effects.flow || has_solids(scene); }

}  // namespace shmoo::scene
