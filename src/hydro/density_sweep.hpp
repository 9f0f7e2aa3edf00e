#pragma once
// The first sweep over pairs: kernel values into the rows, second moments, corrected velocity gradient, rate of
// density, and what the slots of this sweep (density diffusion, transport velocity) add.
#include "hydro/effects/list.hpp"
#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// Writes rows.weight of fluid rows, next_density after `dt` [s] (of fluid; 0: as it is), acceleration (the part that
// the transport velocity causes), and the columns scaling, correction and shift where they exist. `next_dt` [s] is the
// step in which the shift will act.
template <int D>
void sweep_density(State<D>& state, const sph::AnyKernel<D>& kernel, const Effects<D>& effects, double dt,
                   double next_dt);

extern template void sweep_density(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&, double, double);
extern template void sweep_density(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&, double, double);

}  // namespace shmoo::hydro
