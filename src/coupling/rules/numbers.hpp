#pragma once
// The numbers of a scene by which its rules decide and its limits judge: dimensionless ratios and what they are made
// of.
#include <limits>
#include <string>
#include <vector>

#include "hydro/scales.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

inline constexpr double nothing_known = std::numeric_limits<double>::quiet_NaN();

struct SpeciesNumbers {
  std::string name;
  double diffusivity = 0;  // [m^2/s]
  double start = 0;        // molecules in all at the start
  double reference = 0;  // [molecules/m^3] the largest that the scene tells of, at the start or later; 0: it tells none
  double per_voxel = 0;  // molecules in a voxel at that concentration
  std::size_t home = 0;  // voxels that it lives in
  double least = 0;      // molecules in a voxel of its home at the start, where they are fewest
  double turnover = 0;   // [1/s] at which reactions use it up at the reference concentrations
  bool carried = false;  // it lives in a fluid that moves
  int surfaces = 0;      // reactions on surfaces that it takes part in
  bool catalyses_itself = false;  // a reaction that it takes part in makes more of it
};

struct FlowNumbers {
  double driven_speed = 0;       // [m/s] without thermal motion; 0: nothing drives it
  double thermal_speed = 0;      // [m/s] sqrt(D kT/m) of a particle, at room temperature where the scene names none
  double thermal_energy = 0;     // [J] that kT
  double mass = 0;               // [kg] of a particle
  double speed = 0, length = 0;  // [m/s], [m] U and L
  double kinematic_viscosity = 0, density = 0;            // [m^2/s], [kg/m^3]
  double body_force = 0;                                  // [m/s^2]
  double sound_speed = 0, smoothing = 0;                  // [m/s], [m] c0 and hs
  bool shocks = false;                                    // it is an isothermal gas, see hydro::Scales
  double step = std::numeric_limits<double>::infinity();  // [s] the time step
  std::string step_rule;                                  // which limit sets it
  std::vector<hydro::StepLimit> limits;

  double reynolds() const { return speed * length / kinematic_viscosity; }
  double cell_reynolds(double spacing) const { return speed * spacing / kinematic_viscosity; }
  double mach() const { return speed / sound_speed; }
  double thermal_ratio() const { return thermal_speed / driven_speed; }  // infinite where nothing drives
  // Sound that viscosity lets cross a kernel's width: below 1 it is damped within.
  double sound_per_viscosity() const { return sound_speed * smoothing / (4.0 * kinematic_viscosity); }
};

struct Numbers {
  double spacing = 0, voxel = 0;  // [m], [m^3] volume of a voxel
  double length = 0;              // [m] of the fluid, else the smallest extent of the domain
  std::size_t voxels = 0, particles = 0;
  int dimension = 0;
  bool walls = false;                                           // anything that a fluid cannot pass
  FlowNumbers flow;                                             // where the scene's flow is on
  double solid_step = std::numeric_limits<double>::infinity();  // [s] the time step of elastic solids
  std::vector<SpeciesNumbers> species;

  double peclet(const SpeciesNumbers& one) const { return flow.speed * length / one.diffusivity; }
  double cell_peclet(const SpeciesNumbers& one) const { return flow.speed * spacing / one.diffusivity; }
  double damkohler(const SpeciesNumbers& one) const { return one.turnover * length * length / one.diffusivity; }
  double schmidt(const SpeciesNumbers& one) const { return flow.kinematic_viscosity / one.diffusivity; }
  // Diffusivity [m^2/s] that thermal velocities add to all that is carried: kT/(6 pi eta a), a half a spacing (Donev,
  // Bell, de la Fuente & Garcia 2011, "Diffusive transport by thermal velocity fluctuations").
  double thermal_diffusivity() const;
};

// Places the particles of the scene. What "auto" leaves open counts as it is without rules. Throws base::InputError
// where the scene cannot be built.
Numbers numbers_of(const scene::Scene& scene);

}  // namespace shmoo::coupling
