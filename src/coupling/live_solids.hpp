#pragma once
// Where the coupling meets elastic solids: solids in motion without a fluid, and what solids add to a picture.
#include <memory>

#include "coupling/live_flow.hpp"
#include "hydro/solid/solids.hpp"

namespace shmoo::coupling {

template <int D>
std::unique_ptr<LiveFlow<D>> make_live_solids(const scene::Scene& scene);

// Puts places, velocities, densities, pressures and displacements of solids into the picture, and their energies.
template <int D>
void add_solids(const hydro::Solids<D>& solids, FlowPicture<D>& picture);

}  // namespace shmoo::coupling
