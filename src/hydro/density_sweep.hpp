#pragma once
// The first sweep over pairs: who is near, second moments, corrected velocity gradient, rate of density, and what the
// slots of this sweep (density diffusion, transport velocity) add.
#include "hydro/effects/list.hpp"
#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// Reads the slots' velocity, volume and density. Of fluid particles it writes density after `dt` [s] (0: as it is),
// volume, pressure, acceleration (the part that the transport velocity causes), the columns scaling, correction and
// shift where they exist, and the blocks' lists of who is near. `next_dt` [s] is the step in which the shift will act.
template <int D>
void sweep_density(State<D>& state, const sph::AnyKernel<D>& kernel, const Effects<D>& effects, double dt,
                   double next_dt);

extern template void sweep_density(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&, double, double);
extern template void sweep_density(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&, double, double);

}  // namespace shmoo::hydro
