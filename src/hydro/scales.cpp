#include "hydro/scales.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "hydro/compressibility.hpp"
#include "hydro/effects/buoyancy.hpp"
#include "hydro/effects/closed_room.hpp"
#include "hydro/effects/pressure.hpp"
#include "hydro/extents.hpp"
#include "hydro/lattice_moments.hpp"
#include "hydro/open/opening.hpp"
#include "hydro/speeds.hpp"
#include "scene/motion.hpp"
#include "scene/refinement.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {
namespace {

// The one fluid of the scene: every fluid material must have the same properties.
const scene::Material& only_fluid(const scene::Scene& scene) {
  const scene::Material* fluid = nullptr;
  for (const auto& material : scene.materials) {
    if (material.type != scene::MaterialType::fluid) continue;
    if (fluid == nullptr) fluid = &material;
    if (material.density != fluid->density || material.viscosity != fluid->viscosity ||
        material.bulk_viscosity != fluid->bulk_viscosity) {
      throw base::InputError(
          fmt::format("the fluids '{}' and '{}' differ in density or viscosity; a flow has one fluid: give "
                      "all fluid materials the same values",
                      fluid->name, material.name));
    }
  }
  if (fluid == nullptr)
    throw base::InputError("effects.flow is on but no material is a fluid; add one or turn the flow off");
  if (!(fluid->density > 0.0)) {
    throw base::InputError(fmt::format("fluid '{}' has no density; a flow needs a positive one", fluid->name));
  }
  return *fluid;
}

// The smallest extent between walls, or of the domain where there are none.
template <int D>
double default_length(const scene::Scene& scene) {
  double walled = std::numeric_limits<double>::infinity(), any = walled;
  for (int a = 0; a < D; ++a) {
    any = std::min(any, extent(scene, a));
    if (has_friction(scene, a)) walled = std::min(walled, extent(scene, a));
  }
  return std::isfinite(walled) ? walled : any;
}

// What an inflow must push against: the pressure drop over density [m^2/s^2] of plane Poiseuille flow of mean speed U
// along each axis that has an inflow, between the walls of the others; 0 without inflow or walls. `nu_U` [m^3/s^2].
template <int D>
double channel_drop(const scene::Scene& scene, double nu_U) {
  double drop = 0.0;
  const auto push = [&](int along) {
    for (int across = 0; across < D; ++across) {
      if (across == along || !has_friction(scene, across)) continue;
      drop = std::max(drop, 12.0 * nu_U * extent(scene, along) / (extent(scene, across) * extent(scene, across)));
    }
  };
  for (int along = 0; along < D; ++along) {
    for (const auto& inflow : scene.inflows)
      if (inflow.velocity && (*inflow.velocity)[std::size_t(along)] != 0.0) push(along);
    for (const auto& side : scene.domain.sides[std::size_t(along)])
      if (!side.inflow.empty()) push(along);
  }
  return drop;
}

template <int D>
void derive_sound(const scene::Scene& scene, Scales<D>& scales, std::vector<Derived>& derived) {
  const double U = scales.speed, L = scales.length, nu = scales.kinematic_viscosity();
  double force = 0.0;
  for (int a = 0; a < D; ++a) {
    const double f = std::abs(scales.body_force[a]) + scales.lightness * std::abs(scales.gravity[a]);
    force += f * (passes(scene, a) ? L : extent(scene, a));
  }
  const double terms[] = {U * U, nu * U / L, force, channel_drop<D>(scene, U * nu),
                          held_pressure_drop(scene) / scales.density};
  const char* names[] = {"U^2", "nu U/L", "|f| L", "12 nu U l/w^2", "dp/rho"};
  const auto largest = std::size_t(std::max_element(terms, terms + 5) - terms);
  std::string why;
  if (scene.flow.sound_speed) {
    scales.sound_speed = *scene.flow.sound_speed;
    why = "flow.sound_speed";
  } else {
    scales.sound_speed = std::sqrt(terms[largest] / scene.flow.density_variation);
    why = fmt::format(
        "sqrt({}/{:g}), the largest of U^2, nu U/L, |f| L and, for an inflow, the "
        "pressure drop over a channel of length l and width w (or between open sides), over the allowed density "
        "variation",
        names[largest], scene.flow.density_variation);
  }
  if (!(scales.sound_speed > 0.0)) {
    throw base::InputError(
        "nothing in this scene sets the flow in motion, so no speed of sound can be derived; give "
        "flow.reference_speed, or turn effects.flow off");
  }
  derived.push_back({"sound speed", scales.sound_speed, "m/s", why});
}

template <int D>
void derive_noise(const scene::Scene& scene, Scales<D>& scales) {
  if (!scene.effects.thermal_noise) return;
  if (!scene.flow.thermal_energy)
    throw base::InputError("effects.thermal_noise is on but the scene has no temperature");
  if (!scene.effects.viscosity) {
    throw base::InputError(
        "effects.thermal_noise needs effects.viscosity: without friction nothing balances the noise");
  }
  scales.thermal_energy = *scene.flow.thermal_energy / scales.depth;
  const double alpha = friction_alpha<D>(scales.viscosity, scales.bulk_viscosity);
  if (alpha >= 0.0) return;
  throw base::InputError(
      fmt::format("bulk viscosity {:g} Pa s is too large for thermal noise; at most {:g} Pa s is allowed "
                  "for this shear viscosity",
                  scales.bulk_viscosity, scales.viscosity * (D + 2) / D));
}

// A fluid far beyond Mach 0.3 that fills its room is treated as what its state equation makes it, an isothermal gas:
// its pressure is rho c0^2, never negative, so that nothing clumps where it is torn; densities are summed over
// particles, as what is integrated does not come back from a shock; and particles are not shifted, which squeezes mass
// through shocks.
template <int D>
void derive_shocks(const scene::Scene& scene, const sph::Filling<D>& filling, Scales<D>& scales,
                   std::vector<Derived>& derived) {
  const auto& numerics = scene.numerics;
  const bool ruled = numerics.pressure == scene::PressureForm::automatic &&
                     numerics.density == scene::DensityForm::automatic && numerics.shepard_every == 0;
  if (!ruled || pressure_form<D>(scene, scales) != scene::PressureForm::riemann) return;
  if (scene::has_solids(scene) || scene::has_open_sides(scene) || scene::refined(scene) || !is_enclosed<D>(filling))
    return;
  scales.shocks = true;
  scales.background = std::max(scales.background, scales.density * scales.sound_speed * scales.sound_speed);
  derived.push_back({"background pressure", scales.background, "Pa",
                     "rho0 c0^2: beyond Mach 0.3 the fluid is an isothermal gas, whose pressure is never negative; its "
                     "densities are summed and its particles not shifted"});
}

// Sums over the starting lattice: gamma = (alpha + beta/D) sum_j V_j F_ij/rho, and sum_j W_ij.
template <int D>
void sum_lattice(const scene::Scene& scene, Scales<D>& scales) {
  const double F = lattice_sum_F(scene, scales, 0);
  const double alpha = friction_alpha<D>(scales.viscosity, scales.bulk_viscosity);
  const double beta = friction_beta<D>(scales.viscosity, scales.bulk_viscosity);
  scales.friction = (alpha + beta / D) * F * std::pow(scales.spacing, D) / scales.density;
  scales.lattice_sum = lattice_sum(scene, scales, [](const auto& kernel, double r) { return kernel.W(r); });
}

// Densities are summed where there is noise.
template <int D>
void stiffen(const scene::Scene& scene, Scales<D>& scales, std::vector<Derived>& derived) {
  if (!(scales.thermal_energy > 0.0)) return;
  const auto kernel = sph::make_kernel<D>(scene.numerics.kernel, scales.reach);
  const double self = std::visit([](const auto& each) { return each.W(0.0); }, kernel) / scales.lattice_sum;
  scales.stiffness = stiffness(self, scales.thermal_energy / (scales.mass * scales.sound_speed * scales.sound_speed));
  derived.push_back({"stiffness of the state equation", scales.stiffness, "1",
                     "so that density fluctuates by the sound speed, although particles count themselves"});
}

template <int D>
void refuse_small_box(const scene::Scene& scene, const Scales<D>& scales) {
  for (int a = 0; a < D; ++a) {
    if (!is_periodic(scene, a) || extent(scene, a) > 1.999999 * scales.reach) continue;
    throw base::InputError(
        fmt::format("the periodic extent {:g} m along axis {} is smaller than twice the kernel's reach of "
                    "{:g} m; make the domain larger or the spacing smaller",
                    extent(scene, a), "xyz"[a], scales.reach));
  }
}

// What the scene says of a fluid, before its speeds are known.
template <int D>
Scales<D> scales_at_rest(const scene::Scene& scene, const sph::Filling<D>& filling) {
  if (scene.dimension != D) throw std::logic_error("scales_at_rest: dimension of scene and flow differ");
  const auto& fluid = only_fluid(scene);
  Scales<D> scales;
  scales.spacing = std::pow(filling.cell, 1.0 / D);
  scales.finest = scene::refined(scene) ? 0.5 * scales.spacing : scales.spacing;
  scales.reach = scene.numerics.reach * scales.spacing;
  scales.smoothing = 0.5 * scales.reach;
  scales.density = fluid.density;
  if (scene.effects.viscosity) {
    scales.viscosity = fluid.viscosity;
    scales.bulk_viscosity = fluid.bulk_viscosity;
    // Friction along the line of centres: only then does a solid that turns feel the torque that it should.
    if (scene::has_solids(scene)) scales.bulk_viscosity = scales.viscosity * (D + 2) / D;
  }
  scales.mass = fluid.density * filling.cell;
  scales.depth = D == 2 ? scene.depth : 1.0;
  scales.background = scene.flow.background_pressure;
  scales.courant = scene.numerics.courant;
  if (scene.flow.body_force) scales.body_force = vector_of<D>(*scene.flow.body_force);
  scales.gravity = vector_of<D>(scene.flow.gravity);
  scales.lightness = largest_lightness(scene);
  scales.length = scene.flow.reference_length.value_or(default_length<D>(scene));
  return scales;
}

}  // namespace

template <int D>
double driven_speed(const scene::Scene& scene, const sph::Filling<D>& filling) {
  return largest_speed<D>(scene, filling, scales_at_rest<D>(scene, filling)).speed;
}

template <int D>
Scales<D> derive_scales(const scene::Scene& scene, const sph::Filling<D>& filling, std::vector<Derived>& derived) {
  Scales<D> scales = scales_at_rest<D>(scene, filling);
  refuse_small_box<D>(scene, scales);
  derive_noise<D>(scene, scales);
  const auto [speed, speed_why] = largest_speed<D>(scene, filling, scales);
  scales.speed = speed;
  derived.push_back({"reference speed", scales.speed, "m/s", speed_why});
  derived.push_back(
      {"reference length", scales.length, "m",
       scene.flow.reference_length ? "flow.reference_length" : "smallest extent between walls, or of the domain"});
  derive_sound<D>(scene, scales, derived);
  derive_shocks<D>(scene, filling, scales, derived);
  sum_lattice<D>(scene, scales);
  stiffen(scene, scales, derived);
  if (scene::has_solids(scene) && scales.viscosity > 0.0) {
    derived.push_back({"bulk viscosity", scales.bulk_viscosity, "Pa s",
                       "so that friction acts along the line of centres, for the torque on elastic solids"});
  }
  if (scene::refined(scene))
    derived.push_back({"fine spacing", scales.finest, "m", "half of domain.spacing, in [[refinement]]"});
  derived.push_back({"smoothing length", scales.smoothing, "m", "half the kernel's reach"});
  derived.push_back({"particle mass", scales.mass * scales.depth, "kg", "density times what one particle fills"});
  return scales;
}

template <int D>
Scales<D> Scales<D>::of_finest() const {
  Scales fine = *this;
  const double narrowing = finest / spacing;
  fine.spacing = finest;
  fine.reach *= narrowing;
  fine.smoothing *= narrowing;
  fine.mass *= std::pow(narrowing, D);
  return fine;
}

template <int D>
void list_base_limits(const Scales<D>& scales, std::vector<StepLimit>& limits) {
  const double sound = std::sqrt(scales.stiffness) * scales.sound_speed;
  limits.push_back({"acoustic", scales.courant * scales.smoothing / (sound + scales.speed),
                    fmt::format("{:g} hs/(c0 + U)", scales.courant)});
}

template struct Scales<2>;
template struct Scales<3>;
template Scales<2> derive_scales(const scene::Scene&, const sph::Filling<2>&, std::vector<Derived>&);
template Scales<3> derive_scales(const scene::Scene&, const sph::Filling<3>&, std::vector<Derived>&);
template double driven_speed(const scene::Scene&, const sph::Filling<2>&);
template double driven_speed(const scene::Scene&, const sph::Filling<3>&);
template void list_base_limits(const Scales<2>&, std::vector<StepLimit>&);
template void list_base_limits(const Scales<3>&, std::vector<StepLimit>&);

}  // namespace shmoo::hydro
