#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/rules/limits.hpp"

namespace shmoo::coupling {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Limit mach(const Numbers& numbers) {
  const auto& flow = numbers.flow;
  return {"Mach number",
          flow.mach(),
          0.1,
          1.0,
          fmt::format("U/c0 = {:.3g}/{:.3g} m/s; density varies by its square{}", flow.speed, flow.sound_speed,
                      flow.shocks ? "; computed as an isothermal gas" : ""),
          fmt::format("leave flow.sound_speed out, or give at least {:.3g} m/s", 10.0 * flow.speed),
          "Monaghan 1994: density variation (U/c0)^2, 1 % at 0.1"};
}

// Points of the lattice within the kernel's reach, the particle itself left out.
int neighbours(int dimension, double reach) {
  const int most = int(std::ceil(reach)), depth = dimension == 3 ? most : 0;
  int count = -1;
  for (int k = -depth; k <= depth; ++k)
    for (int j = -most; j <= most; ++j)
      for (int i = -most; i <= most; ++i) count += i * i + j * j + k * k < reach * reach ? 1 : 0;
  return count;
}

// Judged upside down, as the shortage: too few are too few however many there are.
Limit support(const scene::Scene& scene) {
  constexpr double enough = 2.0;  // [spacings]
  const double reach = scene.numerics.reach;
  const int have = neighbours(scene.dimension, reach), wanted = neighbours(scene.dimension, enough) + 1;
  return {"neighbours wanted over neighbours",
          double(wanted) / have,
          1.0,
          infinite,
          fmt::format("a kernel of reach {:g} spacings sees {} particles; {} are wanted", reach, have, wanted),
          fmt::format("set numerics.reach to more than {:g}", enough),
          "Quinlan, Basa & Lastiwka 2006: the sums' error grows as neighbours get fewer"};
}

Limit wall_layers(const scene::Scene& scene, double layers) {
  const double wanted = std::ceil(scene.numerics.reach);
  return {
      "wall layers wanted over wall layers",
      wanted / layers,
      1.0,
      infinite,
      fmt::format("{:g} layers of particles where walls are thinnest; the kernel reaches over {:g}", layers, wanted),
      fmt::format("make walls at least {:.3g} m thick, or the spacing smaller", wanted * scene.domain.spacing),
      "Adami, Hu & Adams 2012: walls fill the kernel's support"};
}

// Walls are cut from the lattice, and fits on them ask for a radius of a kernel's reach.
Limit bore(const scene::Scene& scene, double diameter) {
  constexpr double wanted = 8.0;
  const double across = diameter / scene.domain.spacing;
  return {
      "particles wanted across a round bore over particles across",
      wanted / across,
      1.0,
      infinite,
      fmt::format("{:.3g} particles across {:.3g} m; with 4 a bore has 5 % too few and with 6 13 % too many "
                  "particles in its cross-section, with 8 3 %, and what is asked to pass is as much too fast or slow",
                  across, diameter),
      fmt::format("set domain.spacing to at most {:.2g} m", diameter / wanted),
      "measured: straight pipes, and a throat behind a cone"};
}

// The fluid's pressures, about rho max(U^2, nu U/L, g L), over the modulus of the softest solid. Tried on a disk in
// vortices (shmoo verify stability, soft-solid): at 1 energy only falls, at 3 it rises by 4 % in 4 s, at 10 to 50 the
// solid is turned inside out.
void add_softness(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  const auto& flow = numbers.flow;
  const double inertia = flow.speed * flow.speed, friction = flow.kinematic_viscosity * flow.speed / flow.length,
               weight = flow.body_force * flow.length, pressure = flow.density * std::max({inertia, friction, weight});
  for (const auto& material : scene.materials) {
    if (!material.elastic || !(pressure > 0.0)) continue;
    const double modulus = material.elastic->shear_modulus;
    limits.push_back(
        {"fluid's pressure over the modulus of " + material.name, pressure / modulus, 1.0, infinite,
         fmt::format("pressures of about {:.3g} Pa on a solid of G = {:.3g} Pa; beyond 1 it may gain energy "
                     "and be turned inside out",
                     pressure, modulus),
         fmt::format("give {} a shear modulus of at least {:.2g} Pa", material.name, pressure),
         "measured: an elastic disk in vortices"});
  }
}

// Beneath thermal noise it does not show.
void add_trembling(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  constexpr double trembling = 0.06;  // of U
  if (scene.numerics.density != scene::DensityForm::summation || scene.effects.thermal_noise) return;
  limits.push_back(
      {"trembling of particles over the flow's speed", trembling, 0.01, infinite,
       fmt::format("summed densities without thermal noise leave particles trembling with about {:.2g} m/s",
                   trembling * numbers.flow.speed),
       "leave numerics.density out", "measured: Taylor-Green vortices at 25^2 and 50^2"});
}

// Where a steady flow passes through particles that stand, too coarse a grid spreads species like diffusion.
void add_cell_peclet(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  if (!scene.numerics.steady_tolerance || !scene.effects.species_advection) return;
  for (const auto& species : numbers.species) {
    if (!species.carried) continue;
    const double value = numbers.cell_peclet(species);
    const auto spacing =
        fmt::format("set domain.spacing to at most {:.2g} m", 2.0 * species.diffusivity / numbers.flow.speed);
    limits.push_back({"cell Peclet number of " + species.name, value, 2.0, infinite,
                      fmt::format("U dp/kappa = {:.3g} x {:.3g}/{:.3g}; beyond 2 a carried flow is taken upwind, which "
                                  "spreads like a diffusivity of U dp/2 = {:.3g} m^2/s",
                                  numbers.flow.speed, numbers.spacing, species.diffusivity,
                                  0.5 * numbers.flow.speed * numbers.spacing),
                      species.diffusivity > 0.0 ? spacing : "leave numerics.steady_tolerance out",
                      "Patankar 1980, ch. 5: central differences to Pe = 2, upwind beyond"});
  }
}

}  // namespace

void judge_flow_limits(const scene::Scene& scene, const Numbers& numbers, std::vector<Limit>& limits) {
  if (numbers.flow.speed > 0.0) limits.push_back(mach(numbers));
  limits.push_back(support(scene));
  if (const double layers = thinnest_wall(scene); std::isfinite(layers)) limits.push_back(wall_layers(scene, layers));
  if (const double diameter = narrowest_bore(scene); std::isfinite(diameter)) limits.push_back(bore(scene, diameter));
  add_softness(scene, numbers, limits);
  add_trembling(scene, numbers, limits);
  add_cell_peclet(scene, numbers, limits);
}

}  // namespace shmoo::coupling
