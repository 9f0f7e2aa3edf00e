#pragma once
// The forms of the pressure force; one of them always acts. The force on i is coefficient * x_ij [N/m^(3-D)], made of
// what stress() gives of each particle.
#include "base/vec.hpp"
#include "hydro/effects/pair.hpp"
#include "hydro/scales.hpp"

namespace shmoo::hydro {

// m_i dv_i/dt = -sum_j m_i m_j (p_i/rho_i^2 + p_j/rho_j^2) grad_i W_ij: conserves momentum pair by pair.
struct SymmetricPressure {
  static constexpr const char* name = "symmetric pressure";
  static constexpr bool corrected = false, sees_velocity = false;
  static double stress(double pressure, double volume) { return pressure * volume * volume; }
  template <int D>
  Lane coefficient(const ForcePair<D>& pair) const {
    return (pair.stress_i + pair.stress_j) * pair.F;
  }
};

// m_i dv_i/dt = -V_i B_i sum_j V_j (p_j - p_i) grad_i W_ij, B_i the inverse second moment: exact for linear pressure,
// does not conserve momentum exactly.
struct DifferencePressure {
  static constexpr const char* name = "difference pressure";
  static constexpr bool corrected = true, sees_velocity = false;
  static double stress(double pressure, double) { return pressure; }
  template <int D>
  Lane coefficient(const ForcePair<D>& pair) const {
    return (pair.stress_j - pair.stress_i) * pair.V_i * pair.V_j * pair.F;
  }
};

// m_i dv_i/dt = -2 sum_j V_i V_j P* grad_i W_ij with P* of the linear Riemann problem between i and j, P* = (p_i +
// p_j)/2 + (1/2) beta rho0 c0 a, a = -v_ij.x_ij/r the speed of approach, beta = min(3 max(a/c0, 0), 1) (Zhang, Hu &
// Adams 2017, "A weakly compressible SPH method based on a low-dissipation Riemann solver", Eqs. 16-18, with rho0 c0
// for the mean impedance, so that pairs are opposite to the bit): conserves momentum pair by pair.
struct RiemannPressure {
  static constexpr const char* name = "Riemann pressure";
  static constexpr bool corrected = false, sees_velocity = true;
  static constexpr double limiter = 3.0;

  double sound_speed = 0;  // [m/s] c0
  double impedance = 0;    // [kg/(m^2 s)] rho0 c0

  static double stress(double pressure, double) { return pressure; }
  template <int D>
  Lane coefficient(const ForcePair<D>& pair) const {
    Lane along = pair.x[0] * pair.v[0];
    for (int a = 1; a < D; ++a) along = fma(pair.x[a], pair.v[a], along);
    const Lane approach = larger(-along * pair.inverse_r, Lane{});
    const Lane part = limiter / sound_speed * approach, beta = part < 1.0 ? part : same(1.0);
    return (pair.stress_i + pair.stress_j + impedance * beta * approach) * pair.V_i * pair.V_j * pair.F;
  }
};

// m_i dv_i/dt = -sum_j V_i V_j (p_i + p_j) grad_i W_ij: what symmetric pressure is where particles differ in mass. The
// form above weighs a pair of unlike volumes by (V_i^2 + V_j^2)/2, and pressure would push them apart.
struct PressureByVolume {
  static constexpr bool corrected = false, sees_velocity = false;
  static double stress(double pressure, double) { return pressure; }
  template <int D>
  Lane coefficient(const ForcePair<D>& pair) const {
    return (pair.stress_i + pair.stress_j) * (pair.V_i * pair.V_j) * pair.F;  // the same from either side
  }
};

// The form that acts where masses differ.
template <class Pressure>
Pressure by_volume(const Pressure& pressure) {
  return pressure;
}
inline PressureByVolume by_volume(const SymmetricPressure&) { return {}; }

// The form that a scene asks for; by rule that which withstands shocks, where its own speed is far beyond those of a
// weakly compressible flow.
inline constexpr double most_subsonic = 0.3;  // Mach number
template <int D>
scene::PressureForm pressure_form(const scene::Scene& scene, const Scales<D>& scales) {
  if (scene.numerics.pressure != scene::PressureForm::automatic) return scene.numerics.pressure;
  const bool fast = scales.speed > most_subsonic * scales.sound_speed;
  return fast && !scene.effects.thermal_noise ? scene::PressureForm::riemann : scene::PressureForm::symmetric;
}

}  // namespace shmoo::hydro
