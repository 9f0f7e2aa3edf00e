#pragma once
// A sponge zone: dq/dt = -(q - target) phi(x)/tau, phi = ((x - xs)/(xe - xs))^n along the flow (thesis Eq. 2.36-2.38
// put into rate form, so that the result does not depend on the time step).
#include "scene/scene.hpp"

namespace shmoo::sph {

class Sponge {
 public:
  // `diffusivity` [m^2/s] (of momentum or of a species) sets the relaxation time where the zone has no velocity.
  Sponge(const scene::Inflow& inflow, double diffusivity, int dimension);

  double relaxation_time() const {
    return relaxation_time_;
  }  // [s]: as given, else a tenth of the time to cross the zone

  // phi/tau at a place [1/s]; 0 outside the zone.
  double rate(const scene::Point& x) const;

 private:
  const scene::Inflow& inflow_;
  int dimension_, axis_ = 0;
  bool along_ = true;  // does phi rise with the coordinate?
  double from_ = 0, length_ = 1, relaxation_time_ = 0;
};

}  // namespace shmoo::sph
