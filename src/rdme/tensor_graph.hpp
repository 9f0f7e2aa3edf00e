#pragma once
// Jumps between particles of a half plane y > 0 whose mirror images make up the rest: a body of revolution about the x
// axis (axial), or a slab. Pair weights are normalised by a tensor per particle, C_i, such that
//   sum_j a_j F_ij r_ij^2 (e.C_i e) e (x) e = I,
// which gives the Laplacian of every quadratic field on any arrangement, beside a surface too, up to the pairs'
// symmetric mean:
//   V_i c_ij = 2 a_i a_j F_ij e.(C_i + C_j)/2 e  x  (2 pi times the distance of the pair's middle from the axis, or the
//   depth).
// Weights that would be negative are zero.
#include <span>

#include "base/vec.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

struct HalfPlane {
  std::span<const base::Vec<2>> position;  // [m], y > 0
  std::span<const double> volume;          // [m^3]
  double reach = 0;                        // [m] of the kernel
  bool axial = true;
  double depth = 1;  // [m] where not axial
};

JumpGraph make_tensor_graph(const HalfPlane& plane);

}  // namespace shmoo::rdme
