#pragma once
// Runs a fluid and keeps the extremes of what must stay bounded.
#include <algorithm>
#include <string>
#include <vector>

#include "hydro/fluid.hpp"
#include "run/verify/case.hpp"
#include "scene/read.hpp"
#include "sph/fill.hpp"

namespace shmoo::run::verify {

struct FlowExtremes {
  double speed = 0;                                           // [m/s] largest
  double density_error = 0;                                   // largest |rho/rho0 - 1|
  double distance = std::numeric_limits<double>::infinity();  // smallest of two particles, in spacings
  double energy_rise = 0;                                     // largest rise between two looks, of the largest energy
  double outside = 0;                                         // particles beyond walls, at any look
  double final_energy = 0;                                    // [J], of the largest
};

inline scene::Scene scene_of(const std::string& text, const scene::Overrides& overrides = {}) {
  return scene::read_scene_text(text, "case.toml", overrides);
}

// A unit square of fluid of unit density, and what else its model says.
inline std::string square(const std::string& spacing, const std::string& viscosity, const std::string& sides,
                          const std::string& rest) {
  return "title = \"A hard case\"\ndimension = 2\ndepth = \"1 m\"\n[domain]\nsize = [\"1 m\", \"1 m\"]\nspacing = \"" +
         spacing + "\"\nboundary = " + sides + "\n[materials.liquid]\ntype = \"fluid\"\ndensity = \"1 kg/m^3\"\n" +
         "viscosity = \"" + viscosity + "\"\n" + rest + "[run]\nuntil = \"1 s\"\n";
}
inline const std::string periodic = "{ x = \"periodic\", y = \"periodic\" }";

// Vortices of unit speed, for such a square.
inline const std::string vortices = R"toml([parameters]
U = "1 m/s"
k = "6.283185307179586 1/m"
[flow]
initial_velocity = ["-U * cos(k*x) * sin(k*y)", "U * sin(k*x) * cos(k*y)"]
reference_speed = "1 m/s"
reference_length = "1 m"
)toml";

template <int D>
double count_outside(const hydro::Fluid<D>& fluid) {
  double outside = 0;
  for (const auto i : fluid.state().rows.fluid()) {
    const auto& x = fluid.particles().position[i];
    for (int a = 0; a < D; ++a) {
      if (!(x[a] >= fluid.box().lower[a] && x[a] <= fluid.box().upper[a])) {
        ++outside;
        break;
      }
    }
  }
  return outside;
}

// Advances to `until` [s] and looks `looks` times on the way; what happens before `settled` [s] does not count.
template <int D>
FlowExtremes watch(hydro::Fluid<D>& fluid, double until, int looks, double settled = 0.0) {
  FlowExtremes seen;
  double energy = fluid.kinetic_energy(), largest = energy, rise = 0.0;
  const double start = fluid.time();
  for (int k = 1; k <= looks; ++k) {
    fluid.advance(start + (until - start) * k / looks);
    const double now = fluid.kinetic_energy();
    largest = std::max(largest, now);
    seen.outside = std::max(seen.outside, count_outside(fluid));
    seen.speed = std::max(seen.speed, fluid.max_speed());
    if (fluid.time() >= settled) {
      rise = std::max(rise, now - energy);
      seen.density_error = std::max(seen.density_error, fluid.density_error());
      seen.distance = std::min(seen.distance, fluid.smallest_distance());
    }
    energy = now;
  }
  seen.energy_rise = largest > 0.0 ? rise / largest : 0.0;
  seen.final_energy = largest > 0.0 ? energy / largest : 0.0;
  return seen;
}

}  // namespace shmoo::run::verify
