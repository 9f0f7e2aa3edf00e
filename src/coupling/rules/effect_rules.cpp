// Which effects a scene calls for.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/observables.hpp"
#include "coupling/rules/rule.hpp"
#include "scene/motion.hpp"

namespace shmoo::coupling {
namespace {

bool records_flow(const scene::Scene& scene) {
  const auto of_flow = [](const auto& observable) { return !of_chemistry(observable.type); };
  const auto field = [](const std::string& name) {
    return name == "velocity" || name == "density" || name == "pressure" || name == "position";
  };
  return std::any_of(scene.observables.begin(), scene.observables.end(), of_flow) ||
         std::any_of(scene.run.record.begin(), scene.run.record.end(), field);
}

// The largest over carried species; 0 where none is carried.
template <class Number>
double largest_of_carried(const Numbers& numbers, Number number) {
  double largest = 0.0;
  for (const auto& species : numbers.species)
    if (species.carried) largest = std::max(largest, number(species));
  return largest;
}

// U L/kappa with the speed that drives: the flow's scales may not be known yet.
double peclet(const Numbers& numbers) {
  return largest_of_carried(numbers, [&](const SpeciesNumbers& species) {
    return numbers.flow.driven_speed * numbers.length / species.diffusivity;
  });
}

double thermal_spread(const Numbers& numbers) {
  return largest_of_carried(
      numbers, [&](const SpeciesNumbers& species) { return numbers.thermal_diffusivity() / species.diffusivity; });
}

// Particles move so many spacings during the run.
double path(const scene::Scene& scene, const Numbers& numbers) {
  return numbers.flow.speed * scene.run.until / numbers.spacing;
}

Verdict no_flow() { return {false, nothing_known, "there is no flow"}; }

Verdict judge_flow(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return {false, 0.0, "nothing drives a fluid"};
  const double value = peclet(numbers);
  if (numbers.flow.driven_speed == 0.0) return {true, value, "the heat bath moves the fluid"};
  const bool carries = largest_of_carried(numbers, [](const auto&) { return 1.0; }) > 0.0;
  if (!carries || records_flow(scene)) return {true, value, "the flow is driven, and it is what is looked at"};
  if (value >= threshold) return {true, value, fmt::format("the flow carries species: Pe = {:.3g}", value)};
  return {false, value, fmt::format("species diffuse {:.3g} times faster than the flow carries them", 1.0 / value)};
}

Verdict judge_noise(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double ratio = numbers.flow.thermal_ratio(), spread = thermal_spread(numbers);
  const bool carries = spread > 0.0;
  const bool matters = ratio > threshold && (!carries || spread > threshold || records_flow(scene));
  const auto said = carries ? fmt::format(
                                  "thermal velocities are {:.3g} of the flow's and spread species by {:.3g} of their "
                                  "diffusivity",
                                  ratio, spread)
                            : fmt::format("thermal velocities are {:.3g} of the flow's", ratio);
  if (!scene.flow.thermal_energy) {
    Verdict verdict{false, ratio, "the scene names no temperature; at 25 degC " + said};
    if (matters) verdict.warning = "thermal noise would matter; give flow.temperature";
    return verdict;
  }
  if (!scene.effects.viscosity) return {false, ratio, "viscosity, which the noise balances, is off"};
  if (numbers.flow.driven_speed == 0.0) return {true, ratio, "nothing but the heat bath moves the fluid"};
  Verdict verdict{matters, ratio, said};
  if (!matters && ratio > threshold)
    verdict.warning = "momentary velocities would fluctuate; record one of them to have thermal noise decided by it";
  return verdict;
}

Verdict judge_viscosity(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double value = numbers.flow.cell_reynolds(numbers.spacing);
  Verdict verdict{
      true, value,
      fmt::format("Re = {:.3g}; walls hold a fluid and vortices end by friction only", numbers.flow.reynolds())};
  if (value > threshold)
    verdict.warning = "the flow has structures finer than a spacing; a smaller domain.spacing resolves them";
  return verdict;
}

Verdict judge_density_diffusion(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double value = numbers.flow.sound_per_viscosity();
  if (scene.effects.thermal_noise) return {false, value, "with thermal noise density is a sum, which cannot diffuse"};
  if (value >= threshold) return {true, value, "sound at the scale of the kernel outlives viscosity and is smoothed"};
  return {false, value, "viscosity damps sound within a kernel's width"};
}

Verdict judge_transport(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double value = path(scene, numbers);
  if (scene.effects.thermal_noise) {
    Verdict verdict{false, value, "it would take heat from the thermal noise (3 % in 2-D)"};
    if (numbers.flow.thermal_ratio() < 1.0 && value > 1.0)
      verdict.warning = "a driven flow may draw particles into lines; look at the smallest distance, or switch it on";
    return verdict;
  }
  if (numbers.flow.shocks)
    return {false, value, "it would squeeze mass through the shocks of an isothermal gas, which the fluid is here"};
  if (value > threshold) return {true, value, "particles move far enough to lose their even spacing"};
  return {false, value, "particles hardly leave their places"};
}

Verdict judge_bounce_back(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double value = path(scene, numbers);
  if (!numbers.walls) return {false, value, "there are no walls"};
  if (value > threshold) return {true, value, "particles move far enough to reach a wall"};
  return {false, value, "no particle moves far enough to reach a wall"};
}

Verdict judge_closed_room(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double value = path(scene, numbers);
  if (scene::has_open_sides(scene)) return {false, value, "the fluid may leave"};
  if (value > threshold) return {true, value, "particles move far enough for their summed volumes to drift"};
  return {false, value, "particles hardly leave their places"};
}

Verdict judge_advection(const scene::Scene& scene, const Numbers& numbers, double threshold) {
  if (!scene.effects.flow) return no_flow();
  const double value = peclet(numbers);
  if (largest_of_carried(numbers, [](const auto&) { return 1.0; }) == 0.0)
    return {false, value, "no species lives in the fluid"};
  if (value >= threshold || scene.effects.thermal_noise) return {true, value, fmt::format("Pe = {:.3g}", value)};
  return {false, value, fmt::format("species diffuse {:.3g} times faster than the flow carries them", 1.0 / value)};
}

constexpr EffectRule rules[] = {
    {"flow", "Pe = U L/kappa of the slowest carried species", 0.01,
     "advection-diffusion equation: carried over diffusive flux", judge_flow, "all motion of the fluid"},
    {"thermal_noise", "sqrt(D kT/m)/U, thermal over driven velocity; kT/(6 pi eta a kappa) for carried species", 0.01,
     "equipartition; Vazquez-Quesada, Ellero & Espanol 2009 (scaling of SDPD noise); Donev et al. 2011 (spreading)",
     judge_noise, "thermal velocities of particles, sqrt(D kT/m)"},
    {"viscosity", "U dp/nu, Reynolds number of a spacing", 10.0, "Navier-Stokes equations: inertia over friction",
     judge_viscosity, "friction, 1/Re of the inertia, and no-slip at walls"},
    {"density_diffusion", "c0 hs/(4 nu), sound over viscosity in a kernel", 1.0,
     "Molteni & Colagrossi 2009; damping of sound by viscosity, 2 nu k^2 against c0 k at k = 2/hs",
     judge_density_diffusion, "smoothing of the density's grid-scale noise; nothing physical"},
    {"transport_velocity", "U t/dp, spacings that a particle moves", 0.1, "Lind, Xu, Stansby & Rogers 2012",
     judge_transport, "even spacing of particles; nothing physical"},
    {"bounce_back", "U t/dp, spacings that a particle moves", 0.5,
     "derivation: a particle starts half a spacing from a wall's surface", judge_bounce_back,
     "the guard against particles that enter walls; nothing physical"},
    {"closed_room", "U t/dp, spacings that a particle moves", 0.1,
     "measured: shifted particles gain 0.1 % of mean density a second in a cavity", judge_closed_room,
     "the volume that fluid and solids have together; nothing physical"},
    {"species_advection", "Pe = U L/kappa of the slowest carried species", 0.01,
     "advection-diffusion equation: carried over diffusive flux", judge_advection,
     "transport of species with the fluid, Pe"},
};

}  // namespace

std::span<const EffectRule> effect_rules() { return rules; }

}  // namespace shmoo::coupling
