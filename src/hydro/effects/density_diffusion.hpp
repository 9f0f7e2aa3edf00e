#pragma once
// Density diffusion (after Molteni & Colagrossi 2009, "A simple procedure to improve the pressure evaluation in
// hydrodynamic context using the SPH"): + 2 delta hs c0 sum_j V_j F_ij (rho_j - rho_i), which raises rho_i where its
// neighbours are denser. Theirs is a Laplacian, which also smooths the pressure that the flow wants. Where kernels are
// never cut (bare_fluid.hpp) the sum has the further factor 1 - c r^2, with c such that the second moment vanishes on
// the lattice: what is left is a fourth derivative, of the right sign for all waves (sum F sum F r^4 >= (sum F r^2)^2).
// Where viscosity damps sound within a kernel's width, c0 hs < 4 nu, it is weakened by c0 hs/(4 nu): it is not
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
  double narrowing = 0;    // [1/m^2] c; 0: a Laplacian

  template <int D>
  static DensityDiffusion derive(const scene::Scene& scene, const Scales<D>& scales);

  template <int D>
  void add(const DensityPair<D>& pair, Lane (&sum)[sums]) const {
    sum[0] = fma(pair.FV * less_product(same(1.0), same(narrowing) * pair.r, pair.r), pair.density, sum[0]);
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
  void add(const DensityPair<D>& pair, Lane (&sum)[sums]) const {
    sum[0] = fma(pair.FV * pair.r, pair.density, sum[0]);
  }

  Lane rate(const Lane (&sum)[sums]) const { return sound_speed * sum[0]; }  // [kg/(m^3 s)]
};

using DiffusionSlot = std::variant<Absent, DensityDiffusion, RiemannDiffusion>;

}  // namespace shmoo::hydro
