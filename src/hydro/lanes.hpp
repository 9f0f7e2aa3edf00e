#pragma once
// What the sweeps over pairs of particles make of lanes (base/lanes.hpp).
#include <cstddef>

#include "base/lanes.hpp"

namespace shmoo::hydro {

using base::any_below;
using base::fma;
using base::inverse_root;
using base::Lane;
using base::LaneArray;
using base::lanes;
using base::larger;
using base::less_product;
using base::load;
using base::same;
using base::store;

// Whether so many particles are enough work in a pair sweep to start threads for. The bits do not depend on it.
inline bool worth_threads(std::size_t particles) { return particles >= 3000; }

inline constexpr double tiny = 1e-300;  // [m^2] added to r^2, so that a particle can meet itself

// Separations along one axis of the box, the shortest image where the axis is periodic; antisymmetric to the bit.
struct Axis {
  double length = 0;  // [m]
  double half = 0;    // [m]; infinite where the axis is not periodic

  template <class Number>
  Number nearest(Number d) const {
    d = d > half ? d - length : d;
    return d < -half ? d + length : d;
  }
};

}  // namespace shmoo::hydro
