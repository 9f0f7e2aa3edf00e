#pragma once
// What elastic solids take of a fluid: the opposite of every pair force that the force sweep gave it.
#include "hydro/effects/list.hpp"
#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// After the force sweep. Writes the accelerations of elastic solids, as if they had the fluid's particle mass.
template <int D>
void sweep_reactions(State<D>& state, const sph::AnyKernel<D>& kernel, const Effects<D>& effects);

extern template void sweep_reactions(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&);
extern template void sweep_reactions(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&);

}  // namespace shmoo::hydro
