#pragma once
// Columns of a shell that have drifted apart are laid anew, evenly along the wall, and the present state becomes the
// reference. What is there moves along the layers only: amounts (stress-free volume, molecules) are kept to round-off
// by piecewise linear reconstruction (van Leer 1977, J. Comput. Phys. 23, 276), positions and elastic stretches are
// interpolated by cubics.
#include "hydro/shell/energy.hpp"

namespace shmoo::hydro {

// Of new column c of a layer: what it takes from old columns, `share` of each one's amount.
struct Take {
  std::size_t from = 0, to = 0;  // particles
  double share = 0;
};

// The largest stretch of any particle since the reference, or its inverse.
double largest_stretch(const Shell& shell, const ShellEnergy& energy);

// Returns who takes how much of everything that is counted by particle.
std::vector<Take> rezone(Shell& shell, const ShellEnergy& energy);

}  // namespace shmoo::hydro
