// The numbers that tell what a model is about.
#include <fmt/format.h>

#include <cmath>

#include "run/explain/report.hpp"

namespace shmoo::run {
namespace {

void add_flow(const scene::Scene& scene, const coupling::FlowNumbers& flow, double spacing,
              std::vector<Telling>& list) {
  list.push_back(
      {"Re", flow.reynolds(), "1", "U L/nu, inertia over friction; what viscosity left out would neglect is 1/Re"});
  list.push_back({"Re of a spacing", flow.cell_reynolds(spacing), "1", "U dp/nu"});
  list.push_back({"Ma", flow.mach(), "1", "U/c0; compressibility changes density by Ma^2"});
  list.push_back({"Ma^2", flow.mach() * flow.mach(), "1", "relative change of density by speed"});
  if (flow.body_force > 0.0)
    list.push_back(
        {"f L/U^2", flow.body_force * flow.length / (flow.speed * flow.speed), "1", "body force over inertia"});
  list.push_back({"kT", flow.thermal_energy, "J", scene.flow.thermal_energy ? "of the scene" : "at 25 degC"});
  list.push_back({"thermal velocity", flow.thermal_speed, "m/s", "sqrt(D kT/m) of a particle"});
  if (flow.driven_speed > 0.0) {
    list.push_back({"thermal velocity/U", flow.thermal_ratio(), "1",
                    scene.effects.thermal_noise ? "thermal noise adds it" : "thermal noise would add it"});
  }
}

void add_species(const scene::Scene& scene, const coupling::Numbers& numbers, std::vector<Telling>& list) {
  for (const auto& one : numbers.species) {
    const auto add = [&](const char* name, double value, const char* meaning) {
      list.push_back({fmt::format("{}, {}", name, one.name), value, "1", meaning});
    };
    add("molecules at the start", one.start, "in all");
    add("molecules per voxel", one.per_voxel, "at the largest concentration that the scene tells of");
    if (one.per_voxel > 0.0)
      add("coefficient of variation", 1.0 / std::sqrt(one.per_voxel), "1/sqrt(n) in such a voxel: what chance adds");
    if (!(one.diffusivity > 0.0)) continue;
    if (one.turnover > 0.0) add("Da", numbers.damkohler(one), "k L^2/D, reaction over diffusion");
    if (!one.carried) continue;
    add("Pe", numbers.peclet(one), "U L/D, carried over diffusive transport");
    add("Pe of a spacing", numbers.cell_peclet(one), "U dp/D");
    if (one.turnover > 0.0) add("Da of the flow", one.turnover * numbers.length / numbers.flow.speed, "k L/U");
    add("Sc", numbers.schmidt(one), "nu/D");
    add("thermal spreading", numbers.thermal_diffusivity() / one.diffusivity,
        scene.effects.thermal_noise ? "kT/(6 pi eta a D): thermal velocities add it to the diffusivity"
                                    : "kT/(6 pi eta a D): thermal noise would add it to the diffusivity");
  }
}

}  // namespace

std::vector<Telling> telling_numbers(const scene::Scene& scene, const coupling::Numbers& numbers) {
  std::vector<Telling> list;
  if (scene.effects.flow && numbers.flow.speed > 0.0) add_flow(scene, numbers.flow, numbers.spacing, list);
  add_species(scene, numbers, list);
  return list;
}

}  // namespace shmoo::run
