#pragma once
// Reactions where two materials meet (Reaction::surface). Each of their species lives in just one of the two.
#include <algorithm>

#include "scene/scene.hpp"

namespace shmoo::scene {

inline bool on_surface(const Reaction& reaction) { return reaction.surface[0] >= 0; }

inline bool lives_in(const Species& species, int material) {
  return std::find(species.homes.begin(), species.homes.end(), material) != species.homes.end();
}

// Whether a surface reaction runs per contact area, as none of its reactants lives in the first material; else per
// molecules there.
inline bool per_area(const Scene& scene, const Reaction& reaction) {
  return on_surface(reaction) &&
         std::none_of(reaction.reactants.begin(), reaction.reactants.end(), [&](const Term& term) {
           return lives_in(scene.species[static_cast<std::size_t>(term.species)], reaction.surface[0]);
         });
}

}  // namespace shmoo::scene
