#pragma once
// The numbers that a flow is computed with, derived from what the scene says, each with its origin. Per-depth
// convention: in 2-D a volume is an area, a mass a mass per depth, a force a force per depth and thermal energy enters
// as kT/depth.
#include <limits>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "scene/scene.hpp"
#include "sph/fill.hpp"

namespace shmoo::hydro {

struct Derived {
  std::string name;
  double value = 0;
  std::string unit;
  std::string why;
};

// An upper limit of the time step [s] and who sets it. Infinite limits are not listed.
struct StepLimit {
  std::string name;
  double value = std::numeric_limits<double>::infinity();
  std::string why;
};

template <int D>
struct Scales {
  double spacing = 0;         // [m] dp; this and what follows from it, of coarse particles where spacings differ
  double finest = 0;          // [m] the smallest spacing
  double reach = 0;           // [m] radius of the kernel's support
  double smoothing = 0;       // [m] hs = reach/2
  double density = 0;         // [kg/m^3] rho0
  double viscosity = 0;       // [Pa s] eta, shear
  double bulk_viscosity = 0;  // [Pa s] zeta
  double mass = 0;            // [kg/m^(3-D)] of one particle
  double depth = 1;           // [m^(3-D)]
  double speed = 0;           // [m/s] U
  double length = 0;          // [m] L
  double sound_speed = 0;     // [m/s] c0
  double background = 0;      // [Pa]
  double stiffness = 1;       // c^2/c0^2 of the state equation, see compressibility.hpp
  double thermal_energy = 0;  // [J/m^(3-D)] kT per depth; 0 without thermal noise
  bool shocks = false;        // faster than weakly compressible flows are, see derive_shocks()
  double courant = 0.25;
  base::Vec<D> body_force = base::Vec<D>::Zero();  // [m/s^2]
  base::Vec<D> gravity = base::Vec<D>::Zero();     // [m/s^2] of buoyancy
  double lightness = 0;                            // largest |b| to expect, see Buoyancy
  double friction = 0;  // [1/s] rate at which the pair friction stops a lone particle among resting ones

  double lattice_sum = 0;  // [1/m^D] sum_j W_ij on the starting lattice, i included

  Scales of_finest() const;  // what step limits look at

  double kinematic_viscosity() const { return viscosity / density; }  // [m^2/s] nu
  double pressure(double rho) const {                                 // [Pa] state equation
    return stiffness * sound_speed * sound_speed * (rho - density) + background;
  }
  double density_at(double pressure) const {  // [kg/m^3]
    return density + (pressure - background) / (stiffness * sound_speed * sound_speed);
  }
};

// Coefficients of the pair friction a = alpha V_i V_j F, b = beta V_i V_j F [Pa s] (Espanol & Revenga 2003, "Smoothed
// dissipative particle dynamics", in D dimensions).
template <int D>
double friction_alpha(double eta, double zeta) {
  return eta * (D + 2) / D - zeta;
}
template <int D>
double friction_beta(double eta, double zeta) {
  return (D + 2) * (zeta + eta * (D - 2) / D);
}

// Throws base::InputError where the scene's flow is not one that can be computed (fluids that differ, no speed to build
// the speed of sound from, ...).
template <int D>
Scales<D> derive_scales(const scene::Scene& scene, const sph::Filling<D>& filling, std::vector<Derived>& derived);

// The largest speed [m/s] that the scene names or drives, thermal motion aside; 0 where nothing drives the fluid.
template <int D>
double driven_speed(const scene::Scene& scene, const sph::Filling<D>& filling);

// The step limits that do not belong to an effect.
template <int D>
void list_base_limits(const Scales<D>& scales, std::vector<StepLimit>& limits);

}  // namespace shmoo::hydro
