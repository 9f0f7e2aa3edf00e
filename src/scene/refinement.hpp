#pragma once
// Zones in which fluid particles stand closer together than elsewhere.
#include "scene/scene.hpp"

namespace shmoo::scene {

inline bool refined(const Scene& scene) { return !scene.domain.refinements.empty(); }

// Why the scene cannot have two spacings, and what to do; null where it can. Effects that are left to "auto" count as
// they stand.
const char* misfit_of_refinements(const Scene& scene);

}  // namespace shmoo::scene
