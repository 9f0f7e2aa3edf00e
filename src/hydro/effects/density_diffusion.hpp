#pragma once
// Density diffusion (Molteni & Colagrossi 2009, "A simple procedure to improve the pressure evaluation in hydrodynamic
// context using the SPH"): + 2 delta hs c0 sum_j V_j F_ij (rho_j - rho_i), which raises rho_i where its neighbours are
// denser. Where viscosity damps sound within a kernel's width, c0 hs < 4 nu, it is weakened by c0 hs/(4 nu): it is not
// needed, and as c0/U is large there the mass that leaks down the pressure would be a large part of the flow.
#include "hydro/effects/absent.hpp"
#include "hydro/effects/pair.hpp"
#include "hydro/scales.hpp"

namespace shmoo::hydro {

struct DensityDiffusion {
  static constexpr const char* name = "density diffusion";
  static constexpr double delta = 0.1;
  static constexpr int sums = 1;
  static constexpr bool by_reach = true;  // the coefficient is one of a pair's hs

  double coefficient = 0;  // [m^2/s] 2 delta hs c0, weakened where viscous

  template <int D>
  static DensityDiffusion derive(const Scales<D>& scales) {
    const double sound = scales.sound_speed * scales.smoothing, nu = scales.kinematic_viscosity();  // [m^2/s]
    return {2.0 * delta * sound * (sound < 4.0 * nu ? sound / (4.0 * nu) : 1.0)};
  }

  template <int D>
  static void add(const DensityPair<D>& pair, Lane (&sum)[sums]) {
    sum[0] = fma(pair.FV, pair.density, sum[0]);
  }

  Lane rate(const Lane (&sum)[sums]) const { return coefficient * sum[0]; }  // [kg/(m^3 s)]
};

// What the speeds U* of the Riemann problems between pairs add to continuity: c0 sum_j V_j F_ij r_ij (rho_j - rho_i),
// see RiemannPressure (the first of its Eqs. 16; that one has rho_i/rho0 as a factor, which is less stable in shocks).
struct RiemannDiffusion {
  static constexpr const char* name = "density diffusion";
  static constexpr int sums = 1;
  static constexpr bool by_reach = false;

  double sound_speed = 0;  // [m/s] c0

  template <int D>
  static void add(const DensityPair<D>& pair, Lane (&sum)[sums]) {
    sum[0] = fma(pair.FV * pair.r, pair.density, sum[0]);
  }

  Lane rate(const Lane (&sum)[sums]) const { return sound_speed * sum[0]; }  // [kg/(m^3 s)]
};

using DiffusionSlot = std::variant<Absent, DensityDiffusion, RiemannDiffusion>;

}  // namespace shmoo::hydro
