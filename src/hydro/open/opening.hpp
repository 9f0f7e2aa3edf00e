#pragma once
// A side through which fluid enters and leaves, and the scales that such sides bring.
#include <optional>
#include <vector>

#include "hydro/initial_velocity.hpp"
#include "sph/fill.hpp"

namespace shmoo::hydro {

template <int D>
struct Opening {
  int axis = 0, side = 0;
  double plane = 0;                            // [m] coordinate of the side
  double depth = 0;                            // [m] of the layers of particles beyond it
  std::optional<InitialVelocity<D>> velocity;  // of what enters, where it is given; else
  double pressure = 0;                         // [Pa] held above the background

  // [m] how far x is beyond the side; negative inside.
  double beyond(const base::Vec<D>& x) const { return side == 0 ? plane - x[axis] : x[axis] - plane; }
  double outward() const { return side == 0 ? -1.0 : 1.0; }
  // The point of the side that is nearest to x.
  base::Vec<D> foot(base::Vec<D> x) const {
    x[axis] = plane;
    return x;
  }
};

template <int D>
std::vector<Opening<D>> openings_of(const scene::Scene& scene, const sph::Filling<D>& filling);

// The largest speed [m/s] of what enters with a given velocity at any time of the run.
template <int D>
double fastest_inflow(const scene::Scene& scene, const sph::Filling<D>& filling);

// The largest difference [Pa] of pressures that open sides hold.
double held_pressure_drop(const scene::Scene& scene);

}  // namespace shmoo::hydro
