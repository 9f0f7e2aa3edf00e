#pragma once
// Zones in which fluid particles stand closer together than elsewhere.
#include "scene/motion.hpp"

namespace shmoo::scene {

inline bool refined(const Scene& scene) { return !scene.domain.refinements.empty(); }

// Whether particles come to be and vanish while the scene runs.
inline bool particles_come_and_go(const Scene& scene) { return has_open_sides(scene) || refined(scene); }

// Why the scene cannot have two spacings, and what to do; null where it can. Effects that are left to "auto" count as
// they stand.
const char* misfit_of_refinements(const Scene& scene);

}  // namespace shmoo::scene
