#include "run/bench/lattice_problem.hpp"

#include "base/random.hpp"

namespace shmoo::run::bench {
namespace {

scene::Scene water() {
  scene::Scene scene;
  scene.dimension = 3;
  scene.materials.resize(1);
  scene.materials[0].name = "water";
  return scene;
}

void add_species(scene::Scene& scene, const std::string& name, double diffusivity) {
  scene.species.push_back({name, {0}, diffusivity, scene::SpeciesMethod::stochastic});
}

void add_reaction(scene::Scene& scene, std::vector<scene::Term> reactants, std::vector<scene::Term> products,
                  double k) {
  const auto name = "reaction " + std::to_string(scene.reactions.size());
  scene.reactions.push_back({name, std::move(reactants), std::move(products), k, {}, {}});
}

}  // namespace

rdme::Voxels lattice(std::array<std::uint32_t, 3> n, std::size_t species) {
  rdme::Voxels voxels;
  const std::uint32_t size = n[0] * n[1] * n[2];
  voxels.volume.assign(size, 1.0);
  voxels.material.assign(size, 0);
  rdme::JumpGraph graph;
  graph.first.push_back(0);
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::array<std::uint32_t, 3> at{i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
    voxels.position.push_back({at[0] + 0.5, at[1] + 0.5, at[2] + 0.5});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const std::uint32_t step : {n[axis] - 1, 1u}) {
        if (n[axis] == 1) continue;
        auto to = at;
        to[axis] = (to[axis] + step) % n[axis];
        graph.target.push_back(to[0] + n[0] * (to[1] + n[1] * to[2]));
        graph.coupling.push_back(1.0);
      }
    }
    graph.first.push_back(graph.target.size());
  }
  voxels.graphs.push_back(std::move(graph));
  voxels.graph_of_species.assign(species, size > 1 ? 0 : -1);
  return voxels;
}

scene::Scene diffusion_scene() {
  auto scene = water();
  add_species(scene, "A", 1.0);
  return scene;
}

scene::Scene binding_scene(double mean) {
  auto scene = water();
  for (const char* name : {"A", "B", "C"}) add_species(scene, name, 1.0);
  add_reaction(scene, {{0, 1}, {1, 1}}, {{2, 1}}, 9.0 / mean);
  add_reaction(scene, {{2, 1}}, {{0, 1}, {1, 1}}, 9.0);
  return scene;
}

scene::Scene ring_scene(int species) {
  auto scene = water();
  for (int s = 0; s < species; ++s) add_species(scene, "X" + std::to_string(s), 0.0);
  for (int s = 0; s < species; ++s) add_reaction(scene, {{s, 1}}, {{(s + 1) % species, 1}}, 1.0);
  return scene;
}

scene::Scene dimer_scene(double k, double back) {
  auto scene = water();
  for (const char* name : {"D", "M"}) add_species(scene, name, 0.0);
  add_reaction(scene, {{1, 2}}, {{0, 1}}, k);
  add_reaction(scene, {{0, 1}}, {{1, 2}}, back);
  return scene;
}

void fill_poisson(rdme::State& state, double mean) {
  base::RandomSequence random({1, 0}, base::Stream::placement, 0);
  for (auto& n : state.count) n = base::poisson(random, mean);
}

}  // namespace shmoo::run::bench
