#pragma once
// What pair sweeps read of a partner, one number per slot of the blocks. Fields that no effect asked for stay empty.
#include <array>

#include "hydro/blocks.hpp"

namespace shmoo::hydro {

template <int D>
struct Slots {
  std::array<LaneArray, D> velocity;  // [m/s]
  LaneArray volume;                   // [m^D]
  LaneArray density;                  // [kg/m^3], where density diffuses
  LaneArray stress;                   // of the form of pressure, see effects/pressure.hpp
  LaneArray scaling, narrowing;       // s, w [1/m^2] of the friction
  std::vector<std::uint32_t> id;      // where there is noise

  Lane own_velocity(std::size_t block, int axis) const {
    return load(velocity[std::size_t(axis)].data() + lanes * block);
  }
};

}  // namespace shmoo::hydro
