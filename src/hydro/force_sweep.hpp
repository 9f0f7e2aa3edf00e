#pragma once
// The second sweep over pairs: pressure, and what the slots of this sweep (viscosity, thermal noise) add.
#include "hydro/effects/list.hpp"
#include "hydro/state.hpp"

namespace shmoo::hydro {

// Adds to acceleration, writes the column noise where it exists. Returns how many random numbers were drawn for pairs,
// each pair counted once. `step` addresses the random numbers.
template <int D>
std::uint64_t sweep_forces(State<D>& state, const Effects<D>& effects, std::uint64_t step);

extern template std::uint64_t sweep_forces(State<2>&, const Effects<2>&, std::uint64_t);
extern template std::uint64_t sweep_forces(State<3>&, const Effects<3>&, std::uint64_t);

}  // namespace shmoo::hydro
