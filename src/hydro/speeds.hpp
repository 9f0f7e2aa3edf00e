#pragma once
// The largest speed that a scene names or drives, from which the speed of sound follows.
#include "hydro/scales.hpp"

namespace shmoo::hydro {

struct SpeedCandidate {
  double speed;  // [m/s]
  const char* why;
};

// `scales` as they are before speeds are known.
template <int D>
SpeedCandidate largest_speed(const scene::Scene& scene, const sph::Filling<D>& filling, const Scales<D>& scales);

}  // namespace shmoo::hydro
