#pragma once
// A fluid that cannot leave, between walls that do not move or in a periodic box, fills its room for ever; its summed
// volumes by continuity do not quite. Pressure moves particles away from a surface, the transport velocity moves them
// back, and only the first changes density: left alone, mean density rises by 0.1 % a second in a lid-driven cavity. So
// all densities are scaled by one factor that closes the volume again.
#include "hydro/state.hpp"

namespace shmoo::hydro {

template <int D>
class ClosedRoom {
 public:
  // `solids` [m^D] is the volume of elastic bodies.
  void prepare(const State<D>& state, const scene::Scene& scene, bool summed, double solids);
  void close(State<D>& state, double solids) const;

 private:
  double room_ = 0;  // [m^D] of fluid and solids together; 0: not closed
};

extern template class ClosedRoom<2>;
extern template class ClosedRoom<3>;

}  // namespace shmoo::hydro
