#pragma once
// The two forms of the pressure force; one of them always acts. The force on i is coefficient * x_ij [N/m^(3-D)], made
// of what stress() gives of each particle.
#include "base/vec.hpp"
#include "hydro/effects/pair.hpp"

namespace shmoo::hydro {

// m_i dv_i/dt = -sum_j m_i m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij: conserves momentum pair by pair.
struct SymmetricPressure {
  static constexpr const char* name = "symmetric pressure";
  static constexpr bool corrected = false;
  static double stress(double pressure, double volume) { return pressure * volume * volume; }
  template <int D>
  static Lane coefficient(const ForcePair<D>& pair) {
    return (pair.stress_i + pair.stress_j) * pair.F;
  }
};

// m_i dv_i/dt = -V_i B_i sum_j V_j (p_j - p_i) grad_i W_ij, B_i the inverse second moment: exact for linear pressure,
// does not conserve momentum exactly.
struct DifferencePressure {
  static constexpr const char* name = "difference pressure";
  static constexpr bool corrected = true;
  static double stress(double pressure, double) { return pressure; }
  template <int D>
  static Lane coefficient(const ForcePair<D>& pair) {
    return (pair.stress_j - pair.stress_i) * pair.V_i * pair.V_j * pair.F;
  }
};

}  // namespace shmoo::hydro
