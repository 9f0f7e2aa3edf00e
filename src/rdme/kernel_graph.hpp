#pragma once
// Jump graphs by kernel weights: c_ij = 2 s_ij V_j F_ij, the images of j counted with j; from home voxels to home and
// clamped ones, in the order of the neighbour rows.
#include "rdme/surroundings.hpp"

namespace shmoo::rdme {

template <int D>
JumpGraph kernel_graph(const Surroundings<D>& around);

extern template JumpGraph kernel_graph(const Surroundings<1>&);
extern template JumpGraph kernel_graph(const Surroundings<2>&);
extern template JumpGraph kernel_graph(const Surroundings<3>&);

}  // namespace shmoo::rdme
