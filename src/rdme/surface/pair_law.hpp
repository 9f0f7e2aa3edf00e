#pragma once
// The propensity of a reaction between a voxel i of one material and a neighbour j of another, k in v = k prod C^nu:
//   with reactants in i:  a_ij = k w_ij V_i^(1 - m_i) prod_(s in i) n_s ... (n_s - nu_s + 1) prod_(s in j) n_s
//   .../V_j^m_j,
//                         w_ij = A_ij/sum_j A_ij: each molecule of i sees the mean concentration of its neighbours;
//   with none:            a_ij = k A_ij prod_(s in j) n_s .../V_j^m_j, k per area: for one molecule [m/s].
// m_i and m_j count the reactants on either side. A molecule that appears in j does so with the same weights, so a
// reversible binding is in detailed balance in each pair.
#include "rdme/laws.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

// What of a_ij does not depend on numbers of molecules.
inline double pair_coefficient(const Law& law, const Surface& surface, std::uint64_t pair, double own_volume,
                               double other_volume) {
  double a = law.constant;
  a *= law.own_order > 0 ? surface.share[pair] * volume_factor(law.own_order, own_volume, 1.0 / own_volume)
                         : surface.area[pair];
  for (int m = law.own_order; m < law.order; ++m) a /= other_volume;
  return a;
}

}  // namespace shmoo::rdme
