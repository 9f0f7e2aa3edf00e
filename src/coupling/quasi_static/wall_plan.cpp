#include "coupling/quasi_static/wall_plan.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "hydro/shell/filling.hpp"

namespace shmoo::coupling {
namespace {

constexpr double balance_tolerance = 1e-9;  // of p R^2
constexpr int inflation_steps = 8;
constexpr double limit_precision = 0.02;  // to which the limit load is told

[[noreturn]] void refuse(const base::Location& where, const std::string& message) {
  throw base::InputError({{where, message}});
}

[[noreturn]] void refuse(const scene::Scene& scene, const std::string& message) {
  refuse(base::Location{scene.file, 0, 0}, message);
}

int find_wall(const scene::Scene& scene) {
  int found = -1;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (scene.materials[m].type != scene::MaterialType::solid) continue;
    if (found >= 0)
      refuse(scene, "quasi-static mechanics knows one solid, the wall, and this scene has more; remove one");
    found = int(m);
  }
  if (found < 0) refuse(scene, "quasi-static mechanics needs a solid: a material of type \"solid\" in a ring");
  if (scene.materials[std::size_t(found)].elastic->law == scene::ElasticLaw::hooke_jaumann)
    refuse(scene,
           "the law \"hooke-jaumann\" has no energy to be least; give the wall \"neo-hookean\" or "
           "\"saint-venant-kirchhoff\"");
  return found;
}

const scene::Region& region_of(const scene::Scene& scene, int material) {
  const scene::Region* found = nullptr;
  for (const auto& region : scene.regions) {
    if (region.material != material) continue;
    if (found) refuse(region.where, "the quasi-static wall has one region, a ring, and this is another; remove one");
    found = &region;
  }
  if (!found) refuse(scene, "the wall has no region; give it one of shape \"ring\"");
  return *found;
}

hydro::Ring ring_of(const scene::Scene& scene, const scene::Region& region, double& centre) {
  const auto* shell = std::get_if<scene::ShellShape>(&region.shape->form);
  if (!shell || !(shell->inner > 0.0))
    refuse(region.where, "the quasi-static wall must be a ring with a cavity; use shape \"ring\"");
  if (std::abs(shell->center[1]) > 1e-9 * shell->outer)
    refuse(region.where,
           fmt::format(
               "the wall's centre must be on the x axis, about which it is symmetric, but its y is {:g} m; set it to 0",
               shell->center[1]));
  centre = shell->center[0];
  const double thick = shell->outer - shell->inner, spacing = scene.domain.spacing;
  const int layers = int(std::lround(thick / spacing));
  if (layers < 2) {
    refuse(
        region.where,
        fmt::format(
            "the wall is {:.3g} spacings thick, which leaves it {} layer of particles; strain across it needs at least "
            "2; make domain.spacing at most {:.3g} m",
            thick / spacing, layers, thick / 1.5));
  }
  const double around = std::numbers::pi * 0.5 * (shell->inner + shell->outer);
  const int columns = scene.mechanics.columns > 0 ? scene.mechanics.columns : int(std::lround(2.0 * around / spacing));
  return {shell->inner, shell->outer, layers, std::max(8, columns)};
}

int filling_of(const scene::Scene& scene, int wall) {
  for (const auto& region : scene.regions)
    if (region.material != wall && scene.materials[std::size_t(region.material)].type != scene::MaterialType::wall)
      return region.material;
  return -1;
}

void refuse_what_is_not_computed(const scene::Scene& scene, int wall) {
  if (scene.dimension != 2)
    refuse(scene, fmt::format("quasi-static mechanics needs dimension = 2, and it is {}", scene.dimension));
  if (scene.effects.flow)
    refuse(scene,
           "nothing flows in a quasi-static scene; set effects.flow = false, and give the cavity a still material");
  if (!(scene.mechanics.turgor > 0.0))
    refuse(scene, "quasi-static mechanics needs mechanics.turgor, the pressure in the cavity");
  if (!scene.boundaries.empty() || !scene.inflows.empty())
    refuse(scene,
           "[[boundary]] and [[inflow]] do not reach a quasi-static wall; use [[mechanics.source]] and reactions");
  for (const auto& species : scene.species) {
    if (species.homes != std::vector<int>{wall})
      refuse(species.where, fmt::format("species '{}' of a quasi-static scene must live in the wall '{}' only",
                                        species.name, scene.materials[std::size_t(wall)].name));
  }
}

bool inflates(hydro::Shell& shell, hydro::Equilibrium& equilibrium, double from, double to, double tolerance) {
  for (int step = 1; step <= inflation_steps; ++step) {
    const auto balance = equilibrium.find(shell, from + (to - from) * step / inflation_steps, tolerance);
    if (!balance.converged || !balance.stable) return false;
  }
  return true;
}

// Goes up to the turgor; where there is no equilibrium, finds the pressure up to which there is one.
void inflate(WallPlan& plan) {
  const double turgor = plan.scene.mechanics.turgor;
  hydro::Equilibrium equilibrium(plan.start);
  hydro::Shell reached = plan.start, tried = reached;
  if (inflates(tried, equilibrium, 0.0, turgor, plan.tolerance)) {
    plan.start = tried;
    plan.length = hydro::length_along_axis(equilibrium.energy().outer_surface(tried));
    return;
  }
  double low = 0.0, high = turgor;
  while (high - low > limit_precision * turgor) {
    const double middle = 0.5 * (low + high);
    tried = reached;
    if (inflates(tried, equilibrium, low, middle, plan.tolerance))
      reached = tried, low = middle;
    else
      high = middle;
  }
  refuse(plan.scene,
         fmt::format("a turgor of {:.4g} Pa is at or beyond the limit load of this wall: it finds a stable equilibrium "
                     "up to about {:.3g} Pa only, beyond that it would "
                     "swell without end (an incompressible ring bears G ln(outer/inner) = {:.3g} Pa); lower "
                     "mechanics.turgor, or make the wall stiffer or thicker",
                     turgor, low, plan.elastic().shear_modulus * std::log(plan.ring.outer / plan.ring.inner)));
}

void fill(WallPlan& plan) {
  if (plan.filling_material < 0) return;
  const double h = plan.scene.domain.spacing, radius = plan.ring.inner - 0.5 * h;
  for (double y = 0.5 * h; y < radius; y += h) {
    for (double x = 0.5 * h; x * x + y * y < radius * radius; x += h) {
      plan.filling.emplace_back(x, y);
      plan.filling.emplace_back(-x, y);
    }
  }
}

}  // namespace

WallPlan::WallPlan(const scene::Scene& of) : scene(of), material(find_wall(of)) {
  refuse_what_is_not_computed(scene, material);
  ring = ring_of(scene, region_of(scene, material), centre);
  filling_material = filling_of(scene, material);
  start = hydro::make_shell(ring, scene.axisymmetric, elastic().law,
                            hydro::moduli(elastic().shear_modulus, elastic().poisson_ratio));
  force_scale = scene.mechanics.turgor * ring.outer * (scene.axisymmetric ? ring.outer : 1.0);
  tolerance = balance_tolerance * force_scale;
  inflate(*this);
  fill(*this);
}

}  // namespace shmoo::coupling
