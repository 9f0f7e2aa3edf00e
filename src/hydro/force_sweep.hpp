#pragma once
// The second sweep over pairs: pressure, friction and noise.
#include "hydro/effects/list.hpp"
#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// Reads the slots' velocity, volume, stress and scaling of who is near as the first sweep found them. Adds to
// acceleration and writes the column noise where it exists. `step` addresses the random numbers. Returns how many were
// drawn, each pair's counted once.
template <int D>
std::uint64_t sweep_forces(State<D>& state, const sph::AnyKernel<D>& kernel, const Effects<D>& effects,
                           std::uint64_t step);

extern template std::uint64_t sweep_forces(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&, std::uint64_t);
extern template std::uint64_t sweep_forces(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&, std::uint64_t);

}  // namespace shmoo::hydro
