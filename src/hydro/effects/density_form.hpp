#pragma once
// The two ways in which density follows the particles; one of them always acts.
#include <cstddef>

#include "hydro/lanes.hpp"

namespace shmoo::hydro {

// d rho_i/dt = -rho_i div v, the divergence from the corrected gradient: exact for linear velocities on any
// arrangement.
struct DensityByContinuity {
  static constexpr const char* name = "density by continuity";
  static constexpr bool summed = false;
};

// rho_i = scale m sum_j W_ij, i included, with scale such that the starting lattice has the density rho0. With
// symmetric pressure this is a Hamiltonian system (Espanol & Revenga 2003), which thermal noise needs: with continuity
// the noise makes density wander off without bound.
struct DensityBySummation {
  static constexpr const char* name = "density by summation";
  static constexpr bool summed = true;
  double factor = 0;  // [kg/m^(3-D)] scale m
};

}  // namespace shmoo::hydro
