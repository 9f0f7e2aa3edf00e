#pragma once
// SDPD viscosity: pair friction -[a v_ij + b e (e.v_ij)], a = alpha V_i V_j F s_ij, b = beta V_i V_j F s_ij (Espanol &
// Revenga 2003, Eq. 58, in D dimensions). s_ij = (s_i + s_j)/2 scales the second moment of the neighbours to its exact
// value, 1/s_i = (1/D) sum_j V_j F_ij r_ij^2.
#include "hydro/effects/absent.hpp"
#include "hydro/effects/pair.hpp"
#include "hydro/scales.hpp"

namespace shmoo::hydro {

template <int D>
struct Viscosity {
  static constexpr const char* name = "viscosity";

  double alpha = 0, beta = 0;  // [Pa s]

  static Slot<Viscosity> choose(const scene::Scene& scene, const Scales<D>& scales) {
    if (!scene.effects.viscosity) return Absent{};
    return Viscosity{friction_alpha<D>(scales.viscosity, scales.bulk_viscosity),
                     friction_beta<D>(scales.viscosity, scales.bulk_viscosity)};
  }

  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const {
    const double nu = (scales.viscosity + scales.bulk_viscosity) / scales.density;
    if (!(nu > 0.0)) return;
    list.push_back({name, 0.125 * scales.smoothing * scales.smoothing / nu, "0.125 hs^2/nu"});
  }

  // The force on i is radial x_ij + relative v_ij.
  void add(const ForcePair<D>& pair, Lane& radial, Lane& relative) const {
    const Lane common = pair.V_i * pair.V_j * pair.F * pair.s;
    relative = -alpha * common;
    Lane along = pair.x[0] * pair.v[0];
    for (int a = 1; a < D; ++a) along = fma(pair.x[a], pair.v[a], along);
    radial = less_product(radial, pair.inverse_r * pair.inverse_r, beta * common * along);
  }
};

// The same where b = 0, as in 2-D without bulk viscosity: gives the same bits in fewer steps.
template <int D>
struct ViscosityAcross {
  double alpha = 0;

  void add(const ForcePair<D>& pair, Lane&, Lane& relative) const {
    relative = -alpha * (pair.V_i * pair.V_j * pair.F * pair.s);
  }
};

}  // namespace shmoo::hydro
