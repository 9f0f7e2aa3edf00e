#include "coupling/rules/numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.hpp"
#include "coupling/splitting.hpp"
#include "hydro/effects/list.hpp"
#include "hydro/solid/solids.hpp"
#include "rdme/initial.hpp"
#include "scene/motion.hpp"
#include "scene/surface.hpp"
#include "scene/well.hpp"

namespace shmoo::coupling {
namespace {

constexpr double room_temperature = 298.15;  // [K]

template <int D>
rdme::Voxels voxels_of(const scene::Scene& scene, const sph::Filling<D>& filling) {
  rdme::Voxels voxels;
  voxels.volume.assign(filling.voxels, filling.cell * scene.depth);
  for (std::size_t i = 0; i < filling.voxels; ++i) {
    voxels.material.push_back(filling.particles.material[i]);
    auto& x = voxels.position.emplace_back();
    for (int a = 0; a < D; ++a) x[std::size_t(a)] = filling.particles.position[i][a];
  }
  return voxels;
}

bool catalyses_itself(const scene::Scene& scene, const rdme::Network& network, int species) {
  const auto count_of = [&](const std::vector<scene::Term>& terms) {
    int count = 0;
    for (const auto& term : terms) count += term.species == species ? term.count : 0;
    return count;
  };
  for (std::size_t r = 0; r < scene.reactions.size(); ++r) {
    const auto& reads = network.reactions()[r].reads;
    const bool read = std::find(reads.begin(), reads.end(), species) != reads.end();
    if (read && count_of(scene.reactions[r].products) > count_of(scene.reactions[r].reactants)) return true;
  }
  return false;
}

int on_surfaces(const scene::Scene& scene, int species) {
  const auto names = [&](const scene::Term& term) { return term.species == species; };
  return int(std::count_if(scene.reactions.begin(), scene.reactions.end(), [&](const scene::Reaction& one) {
    return scene::on_surface(one) && (std::any_of(one.reactants.begin(), one.reactants.end(), names) ||
                                      std::any_of(one.products.begin(), one.products.end(), names));
  }));
}

void add_species(const scene::Scene& scene, const rdme::Voxels& voxels, Numbers& numbers) {
  // As real amounts, whatever their methods.
  scene::Scene smooth = scene;
  for (auto& species : smooth.species) species.method = scene::SpeciesMethod::deterministic;
  const rdme::Network network(smooth);
  const auto state = rdme::initial_state(smooth, network, voxels, {});
  std::vector<double> largest(scene.species.size(), 0.0);
  for (std::size_t s = 0; s < scene.species.size(); ++s) {
    SpeciesNumbers one{.name = scene.species[s].name, .diffusivity = scene.species[s].diffusivity};
    one.least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      const int material = voxels.material[i];
      if (!network.lives_in(int(s), material)) continue;
      const double here = state.amount[i * state.species + s];
      ++one.home;
      one.start += here;
      one.least = std::min(one.least, here);
      largest[s] = std::max(largest[s], here / numbers.voxel);
      const bool fluid = scene.materials[std::size_t(material)].type == scene::MaterialType::fluid;
      one.carried = one.carried || (fluid && scene.effects.flow);
    }
    one.catalyses_itself = catalyses_itself(smooth, network, int(s));
    one.surfaces = on_surfaces(scene, int(s));
    numbers.species.push_back(std::move(one));
  }
  const auto reference = reference_concentrations(scene, largest);
  const auto rate = turnover(scene, reference);
  for (std::size_t s = 0; s < numbers.species.size(); ++s) {
    numbers.species[s].reference = reference[s];
    numbers.species[s].per_voxel = reference[s] * numbers.voxel;
    numbers.species[s].turnover = rate[s];
  }
}

// What needs the scales of the flow, which exist where something moves it.
template <int D>
void add_scales(const scene::Scene& scene, const sph::Filling<D>& filling, FlowNumbers& flow) {
  std::vector<hydro::Derived> ignored;
  const auto scales = hydro::derive_scales<D>(scene, filling, ignored);
  const auto finest = scales.of_finest();
  hydro::list_base_limits(finest, flow.limits);
  hydro::Effects<D>::choose(scene, scales, {}).limits(finest, flow.limits);
  for (const auto& limit : flow.limits) {
    if (limit.value >= flow.step) continue;
    flow.step = limit.value;
    flow.step_rule = limit.name;
  }
  flow.speed = scales.speed;
  flow.length = scales.length;
  flow.body_force = scales.body_force.norm();
  flow.sound_speed = scales.sound_speed;
  flow.smoothing = scales.smoothing;
  flow.shocks = scales.shocks;
}

template <int D>
void add_flow(const scene::Scene& scene, const sph::Filling<D>& filling, Numbers& numbers) {
  FlowNumbers& flow = numbers.flow;
  for (const auto& material : scene.materials) {
    if (material.type != scene::MaterialType::fluid) continue;
    flow.density = material.density;
    flow.kinematic_viscosity = material.viscosity / material.density;
  }
  flow.mass = flow.density * numbers.voxel;
  flow.thermal_energy = scene.flow.thermal_energy.value_or(base::boltzmann * room_temperature);
  flow.thermal_speed = std::sqrt(D * flow.thermal_energy / flow.mass);
  flow.driven_speed = hydro::driven_speed<D>(scene, filling);
  if (flow.driven_speed > 0.0 || scene.effects.thermal_noise) add_scales<D>(scene, filling, flow);
  if (flow.length > 0.0) numbers.length = flow.length;
}

template <int D>
Numbers numbers_in(const scene::Scene& scene) {
  const auto filling = sph::fill<D>(scene);
  Numbers numbers;
  numbers.dimension = D;
  numbers.spacing = std::pow(filling.cell, 1.0 / D);
  numbers.voxel = filling.cell * scene.depth;
  numbers.length = filling.box.size().minCoeff();
  numbers.voxels = filling.voxels;
  numbers.particles = filling.particles.size();
  for (const auto role : filling.particles.role.values())
    numbers.walls |= role != sph::Role::fluid && role != sph::Role::open;
  if constexpr (D > 1) {
    if (scene.effects.flow) add_flow<D>(scene, filling, numbers);
    if (scene::has_solids(scene) && !scene::quasi_static(scene))
      numbers.solid_step = hydro::Solids<D>(scene, filling).step_limit();
  }
  if (!scene.species.empty()) add_species(scene, voxels_of(scene, filling), numbers);
  return numbers;
}

Numbers numbers_in_a_well(const scene::Scene& scene) {
  rdme::Voxels voxels;
  voxels.volume = {1.0};
  voxels.material = {0};
  voxels.position = {{0.0, 0.0, 0.0}};
  Numbers numbers;
  numbers.voxels = 1;
  numbers.voxel = 1.0;
  if (!scene.species.empty()) add_species(scene::in_numbers(scene), voxels, numbers);
  return numbers;
}

}  // namespace

double Numbers::thermal_diffusivity() const {
  const double viscosity = flow.kinematic_viscosity * flow.density;
  return flow.thermal_energy / (6.0 * std::numbers::pi * viscosity * 0.5 * spacing);
}

Numbers numbers_of(const scene::Scene& scene) {
  if (scene::well_mixed(scene)) return numbers_in_a_well(scene);
  switch (scene.dimension) {
    case 1:
      return numbers_in<1>(scene);
    case 2:
      return numbers_in<2>(scene);
    default:
      return numbers_in<3>(scene);
  }
}

}  // namespace shmoo::coupling
