#pragma once
// What a pair effect sees of eight pairs of one particle j, from the side of their eight i. Volumes, masses and forces
// in the per-depth convention.
#include "hydro/lanes.hpp"

namespace shmoo::hydro {

// In the first sweep, where density changes.
template <int D>
struct DensityPair {
  Lane x[D];     // [m] x_i - x_j
  Lane v[D];     // [m/s] v_i - v_j
  Lane r;        // [m]
  Lane FV;       // [1/m^2] F_ij V_j
  Lane density;  // [kg/m^3] rho_j - rho_i
};

// In the second sweep, where forces act.
template <int D>
struct ForcePair {
  Lane x[D];       // [m] x_i - x_j
  Lane v[D];       // [m/s] v_i - v_j
  Lane r2;         // [m^2]
  Lane inverse_r;  // [1/m]
  Lane F;          // [1/m^(D+2)]
  Lane V_i;        // [m^D]
  double V_j;
  Lane stress_i;  // as the form of pressure wants it
  double stress_j;
  Lane s;  // (s_i + s_j)/2, second-moment scaling, where an effect asked for it, less (w_i + w_j)/2 r^2 at fourth order
};

}  // namespace shmoo::hydro
