#pragma once
// Growth of a shell by insertion of stress-free material in both directions of the wall, at the rate
//   gamma = phi C max(0, (sigma_s + sigma_theta)/2 - sigma_y) [1/s]
// of the mean of the tensions along the meridian and round the axis. Ours; after the Lockhart equation (1965, J. Theor.
// Biol. 8, 264), which has the turgor in the tension's place.
#include <span>

#include "hydro/shell/energy.hpp"

namespace shmoo::hydro {

// Along the wall, from tip to back, of unit length.
Vec2 tangent_at(const Shell& shell, std::size_t i);

// [Pa] (sigma_s + sigma_theta)/2.
double mean_tension(const Shell& shell, const ShellEnergy& energy, std::size_t i);

// Inserts what grows in dt [s]. `concentration` [molecules/m^3] by particle. The rate is the one at the end of the step
// as far as the present one tells: where the rate changes by d gamma, the tension is taken to change by -M dt d gamma,
// M = E/(1 - nu) [Pa], which keeps steps stable that are longer than 2/(phi C M).
void grow(Shell& shell, const ShellEnergy& energy, const scene::Growth& growth, std::span<const double> concentration,
          double dt);

}  // namespace shmoo::hydro
