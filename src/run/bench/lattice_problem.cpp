#include "run/bench/lattice_problem.hpp"

#include <cmath>

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

scene::Scene binding_scene() {
  auto scene = water();
  for (const char* name : {"A", "B", "C"}) add_species(scene, name, 1.0);
  add_reaction(scene, {{0, 1}, {1, 1}}, {{2, 1}}, 0.9);
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

double spread_over_voxels(const rdme::State& state, std::size_t voxels) {
  double chi2 = 0.0, degrees = 0.0;
  for (std::size_t s = 0; s < state.species; ++s) {
    const double mean = double(rdme::total_count(state, int(s))) / double(voxels);
    for (std::size_t i = s; i < state.count.size(); i += state.species)
      chi2 += (double(state.count[i]) - mean) * (double(state.count[i]) - mean) / mean;
    degrees += double(voxels - 1);
  }
  return (chi2 - degrees) / std::sqrt(2.0 * degrees);
}

// At equilibrium 0.9 (T_A - C)(T_B - C)/N = 9 C with the conserved totals; the variance of C given them is that of
// three Poisson numbers on the line that keeps both: 1/(1/A + 1/B + 1/C).
double distance_from_equilibrium(const rdme::State& state, std::size_t voxels) {
  const double A = double(rdme::total_count(state, 0)), B = double(rdme::total_count(state, 1)),
               C = double(rdme::total_count(state, 2)), N = double(voxels);
  const double a = A + C, b = B + C, sum = a + b + 10.0 * N;
  const double wanted = 0.5 * (sum - std::sqrt(sum * sum - 4.0 * a * b));
  const double variance = 1.0 / (1.0 / (a - wanted) + 1.0 / (b - wanted) + 1.0 / wanted);
  return (C - wanted) / std::sqrt(variance);
}

}  // namespace shmoo::run::bench
