#pragma once
// SDPD viscosity: pair friction -[a v_ij + b e (e.v_ij)], a = alpha V_i V_j F s_ij, b = beta V_i V_j F s_ij (Espanol &
// Revenga 2003, Eq. 58, in D dimensions). s_ij = (s_i + s_j)/2 scales the second moment of the neighbours to its exact
// value, 1/s_i = (1/D) sum_j V_j F_ij r_ij^2.
//
// What is left is an error k^2 sum_j V_j F r^4: viscosity that is too low by the kernel's width. At fourth order s_ij
// has the further term -w_ij r^2, with s_i and w_i such that sum_j V_j F (s_i - w_i r^2) r^2 = D and the same with r^4
// is 0. Far pairs then drive velocities apart and close ones pull them together the more; on lattices of every kernel
// the operator stays positive for all wave vectors from a reach of 2.5 spacings on. Not for noise, which cannot be
// drawn for such pairs, nor where kernels are cut (bare_fluid.hpp) or densities summed, nor with b, whose directions a
// cubic lattice then tells apart (4 % at a reach of 3): that is in 2-D without bulk viscosity.
#include <fmt/format.h>

#include "hydro/effects/absent.hpp"
#include "hydro/effects/pair.hpp"
#include "hydro/scales.hpp"

namespace shmoo::hydro {

inline constexpr double least_fourth_reach = 2.5;  // [spacings]

template <int D>
bool is_fourth_order(const scene::Scene& scene, const Scales<D>& scales);

template <int D>
struct Viscosity {
  static constexpr const char* name = "viscosity";

  static constexpr double courant = 0.125, courant_fourth = 0.055;  // the latter's spectrum is 2.3 times as high

  double alpha = 0, beta = 0;  // [Pa s]
  bool fourth_order = false;

  static Slot<Viscosity> choose(const scene::Scene& scene, const Scales<D>& scales) {
    if (!scene.effects.viscosity) return Absent{};
    return Viscosity{friction_alpha<D>(scales.viscosity, scales.bulk_viscosity),
                     friction_beta<D>(scales.viscosity, scales.bulk_viscosity), is_fourth_order<D>(scene, scales)};
  }

  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const {
    const double nu = (scales.viscosity + scales.bulk_viscosity) / scales.density;
    if (!(nu > 0.0)) return;
    const double factor = fourth_order ? courant_fourth : courant;
    list.push_back({name, factor * scales.smoothing * scales.smoothing / nu, fmt::format("{} hs^2/nu", factor)});
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

// And at fourth order.
template <int D>
struct ViscosityNarrowed : ViscosityAcross<D> {};

}  // namespace shmoo::hydro
