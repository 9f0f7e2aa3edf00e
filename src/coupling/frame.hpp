#pragma once
// The particles over one interval of time, by id or, with open sides, by place, as chemistry sees them, and a picture
// of the fluid at one moment.
#include <cstdint>
#include <vector>

#include "base/box.hpp"

namespace shmoo::coupling {

// A particle that came or went through an open side of the domain (2 axis + side).
struct Passage {
  std::uint32_t voxel = 0;  // its place among the voxels
  std::uint32_t id = 0;     // its own, never given twice
  int side = 0;
  bool enters = false;
};

template <int D>
struct Frame {
  std::vector<base::Vec<D>> position;  // [m], in the middle of the interval
  std::vector<base::Vec<D>> arrival;   // [m], at its end
  std::vector<base::Vec<D>> drift;     // [m/s], mean transport minus fluid velocity; empty where nothing is carried
  std::vector<double>
      departure_capacity;        // [m^D] what each voxel holds at the beginning; sets the volume that is carried
  std::vector<double> capacity;  // [m^D], in the middle
  std::vector<double> arrival_capacity;  // [m^D], at the end
  double duration = 0;                   // [s] of the interval; 0 where steady
  double relaxation_time = 0;            // [s] in which capacities become like; 0 where steady
  std::vector<bool> vacant;              // voxels without a particle; empty without open sides
  std::vector<Passage> passages;         // in the interval, in order; they count as happening at its beginning
  bool steady = false;                   // nothing changes any more: the frame serves every later interval, too
};

// Where voxels without a particle are put: out of reach of all others.
template <int D>
base::Vec<D> vacancy(const base::Box<D>& box, double reach) {
  return box.lower - base::Vec<D>::Constant(4.0 * reach);
}

template <int D>
struct FlowPicture {
  std::vector<base::Vec<D>> position, velocity;  // [m], [m/s], by id, voxels only
  std::vector<double> density, pressure;         // [kg/m^3], [Pa]
  std::vector<double> particle;                  // persistent id in each place, where particles come and go; or empty
  std::vector<double> share;                     // [1] of a coarse particle's mass, where spacings differ; or empty
  double kinetic_energy = 0;                     // [J]
  double max_speed = 0;                          // [m/s]
  double temperature = 0;                        // [J], kT
  double density_error = 0;                      // max |rho/rho0 - 1|
  double min_distance = 0;                       // smallest distance of two fluid particles, in spacings
  double bounces = 0;                            // particles thrown back at walls so far
  std::vector<base::Vec<D>> displacement;        // [m] of solids, 0 elsewhere; empty where there are none
  double elastic_energy = 0, solid_energy = 0;   // [J] of solids: elastic; elastic and kinetic
  std::vector<double> loads;                     // [N], [N m] by observable, where that is a force or torque on a wall
};

}  // namespace shmoo::coupling
