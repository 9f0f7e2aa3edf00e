#pragma once
// Force and torque of the fluid on a wall.
#include "base/vec.hpp"

namespace shmoo::hydro {

template <int D>
struct WallLoad {
  base::Vec<D> force = base::Vec<D>::Zero();   // [N]
  base::Vec<3> torque = base::Vec<3>::Zero();  // [N m] about the point asked for; in 2-D only z
};

}  // namespace shmoo::hydro
