#pragma once
// Voxels and networks made by hand, for the tests of the chemistry.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::rdme {

// A scene of one material named "water" in which all species live.
inline scene::Scene water() {
  scene::Scene scene;
  scene.dimension = 3;
  scene.materials.resize(1);
  scene.materials[0].name = "water";
  return scene;
}

inline int add_species(scene::Scene& scene, const std::string& name, double diffusivity = 0,
                       scene::SpeciesMethod method = scene::SpeciesMethod::stochastic) {
  scene.species.push_back({name, {0}, diffusivity, method});
  return static_cast<int>(scene.species.size()) - 1;
}

inline void add_reaction(scene::Scene& scene, const std::string& name, std::vector<scene::Term> reactants,
                         std::vector<scene::Term> products, double rate_constant, const std::string& expression = {}) {
  scene.reactions.push_back({name, std::move(reactants), std::move(products), rate_constant, expression, {}});
}

// A lattice of nx * ny * nz voxels of equal volume; a species of diffusivity 1 jumps to each neighbour at rate 1.
inline Voxels lattice(std::array<std::uint32_t, 3> n, bool periodic, double volume, std::size_t species) {
  Voxels voxels;
  const std::uint32_t size = n[0] * n[1] * n[2];
  voxels.volume.assign(size, volume);
  voxels.material.assign(size, 0);
  JumpGraph graph;
  graph.first.push_back(0);
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::array<std::uint32_t, 3> at{i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
    voxels.position.push_back({at[0] + 0.5, at[1] + 0.5, at[2] + 0.5});
    for (int axis = 0; axis < 3; ++axis) {
      for (int step : {-1, 1}) {
        auto to = at;
        to[axis] += step;  // wraps below 0 to a huge number
        if (to[axis] >= n[axis]) {
          if (!periodic || n[axis] == 1) continue;
          to[axis] = step < 0 ? n[axis] - 1 : 0;
        }
        graph.target.push_back(to[0] + n[0] * (to[1] + n[1] * to[2]));
        graph.coupling.push_back(1.0);
      }
    }
    graph.first.push_back(graph.target.size());
  }
  voxels.graphs.push_back(std::move(graph));
  voxels.graph_of_species.assign(species, 0);
  return voxels;
}

// n * n disordered voxels, periodic, with the 28 neighbours within three spacings: couplings fall off as a kernel's do
// and differ from pair to pair; a molecule jumps about once per unit time.
inline Voxels disordered(std::uint32_t n, std::size_t species) {
  Voxels voxels = lattice({n, n, 1}, true, 1.0, species);
  JumpGraph graph;
  graph.first.push_back(0);
  const auto unevenness = [](std::uint32_t i, std::uint32_t j) {
    const std::uint64_t low = std::min(i, j), high = std::max(i, j);
    return 0.6 + 0.8 * static_cast<double>((low * 2654435761U + high * 40503U) % 1024) / 1024;
  };
  for (std::uint32_t i = 0; i < n * n; ++i) {
    for (int dy = -3; dy <= 3; ++dy) {
      for (int dx = -3; dx <= 3; ++dx) {
        const double r2 = dx * dx + dy * dy;
        if (r2 == 0 || r2 > 9) continue;
        const std::uint32_t j = (i % n + n + dx) % n + n * ((i / n + n + dy) % n);
        graph.target.push_back(j);
        graph.coupling.push_back(0.16 * std::pow(1 - std::sqrt(r2) / 3.2, 3) * unevenness(i, j));
      }
    }
    graph.first.push_back(graph.target.size());
  }
  voxels.graphs = {std::move(graph)};
  return voxels;
}

// Every voxel holds `count` molecules of a species.
inline void fill(State& state, int species, std::int64_t count) {
  for (std::size_t i = species; i < state.count.size(); i += state.species) state.count[i] = count;
}

}  // namespace shmoo::rdme
