#pragma once
// Transport velocity: particles move with v~ = v + dv, dv pointing to where particles are sparse, so that they stay
// evenly spaced. dv_i = -4 xi U hs sum_j V_j grad W_ij, its displacement in a step capped at 0.4 hs^2 |sum_j V_j grad
// W_ij| (Lind, Xu, Stansby & Rogers 2012, "Incompressible smoothed particle hydrodynamics for free-surface flows", with
// U in place of their diffusivity). The velocity carried along changes by (dv . grad) v, which leaves a uniform
// velocity alone.
#include <algorithm>

#include "hydro/effects/absent.hpp"
#include "hydro/effects/pair.hpp"
#include "hydro/scales.hpp"

namespace shmoo::hydro {

template <int D>
struct TransportVelocity {
  static constexpr const char* name = "transport velocity";
  static constexpr int sums = D;
  static constexpr double most_displacement = 0.4;

  double strength = 0;   // [m^2/s] 4 xi U hs
  double smoothing = 0;  // [m] hs

  static Slot<TransportVelocity> choose(const scene::Scene& scene, const Scales<D>& scales) {
    if (!scene.effects.transport_velocity || scales.shocks) return Absent{};
    const double xi = scene.numerics.pressure == scene::PressureForm::difference ? 1.0 : 4.0;
    return TransportVelocity{4.0 * xi * scales.speed * scales.smoothing, scales.smoothing};
  }

  static void add(const DensityPair<D>& pair, Lane (&sum)[sums]) {
    for (int a = 0; a < D; ++a) sum[a] = fma(pair.FV, pair.x[a], sum[a]);
  }

  // dv [m/s] for the next step of dt [s].
  void shift(const Lane (&sum)[sums], double dt, Lane (&dv)[D]) const {
    const double coefficient = std::min(strength, most_displacement * smoothing * smoothing / dt);
    for (int a = 0; a < D; ++a) dv[a] = coefficient * sum[a];
  }
  // The same where reaches differ: of particles with hs = narrowing * smoothing.
  void shift(const Lane (&sum)[sums], double dt, const Lane& narrowing, Lane (&dv)[D]) const {
    const Lane most = most_displacement * smoothing * smoothing / dt * narrowing * narrowing;
    const Lane wanted = strength * narrowing, coefficient = wanted < most ? wanted : most;
    for (int a = 0; a < D; ++a) dv[a] = coefficient * sum[a];
  }
};

}  // namespace shmoo::hydro
