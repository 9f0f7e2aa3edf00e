#pragma once
// The network of a scene as SBML, Level 3 Version 1 core.
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace shmoo::scene {

// `molecules`: of each species at the start. A well-mixed scene keeps its compartments; the chemistry of one with
// particles becomes one compartment of `volume` [m^3], with a note that says so. Throws base::InputError where a rate
// depends on the place or a formula uses a function that SBML does not have.
std::string export_sbml(const Scene& scene, const std::vector<double>& molecules, double volume);

}  // namespace shmoo::scene
