#pragma once
// Well-mixed scenes: volumes, and the same scene told in numbers of molecules.
#include <optional>

#include "scene/scene.hpp"

namespace shmoo::scene {

inline bool well_mixed(const Scene& scene) { return !scene.compartments.empty(); }

// The volume [m^3] that "per volume" means for a reaction of a well-mixed scene: of the compartment of its reactants
// or, where there are none, of its products. Nothing where they live in several.
std::optional<double> volume_of(const Scene& scene, const Reaction& reaction);

// A well-mixed scene in which every volume is 1, so that concentrations are numbers of molecules and rates are events
// per second: a = V v, with n/V of each species' own compartment in v. To be run in one voxel of volume 1.
Scene in_numbers(Scene scene);

}  // namespace shmoo::scene
