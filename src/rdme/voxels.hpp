#pragma once
// The geometry that chemistry sees: particles at frozen positions as voxels, the jumps between them and their exchange
// with reservoirs. Voxels are numbered by persistent particle id. The same numbers drive every method, so the mean of
// an exact sampler is the deterministic solution for first-order networks.
#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace shmoo::rdme {

class UnlistedJumps;

// Jumps of one habitat (a set of home materials), rows over all voxels; the row of a voxel outside the habitat is
// empty.
struct JumpGraph {
  std::vector<std::uint64_t> first;   // [voxels + 1]
  std::vector<std::uint32_t> target;  // [pairs] voxel
  std::vector<double> coupling;       // [pairs] [1/m^2], V_i coupling_ij == V_j coupling_ji
  std::vector<double> flow;  // [pairs] [m^3/s] carried from i to j, antisymmetric; empty where nothing is carried
};

// Rate [1/s] per molecule of species with diffusivity kappa [m^2/s] to jump along pair p out of a voxel of volume V
// [m^3]: central while the pair's Peclet number |q|/(V kappa c) is at most 2, upwind beyond, never negative. The net
// volume that a uniform concentration carries is exactly q in every regime.
inline double jump_rate(const JumpGraph& graph, std::uint64_t p, double kappa, double volume) {
  const double diffusive = kappa * graph.coupling[p];
  if (graph.flow.empty()) return diffusive;
  const double carried = graph.flow[p] / volume;
  const double central = diffusive + 0.5 * carried;
  const double rate = central > carried ? central : carried;
  return rate > 0.0 ? rate : 0.0;
}

// First-order exit to, and Poisson entry from, something outside the simulated state: a side held at a concentration,
// an absorbing or flux side, a sponge, a voxel of a clamped material.
struct Exchange {
  std::uint32_t voxel = 0;
  std::uint32_t species = 0;
  double exit_rate = 0;   // [1/s] per molecule
  double entry_rate = 0;  // [molecules/s]
};

// Where voxels of two materials touch: rows over all voxels, empty but for those of materials[0] that touch one of
// materials[1].
struct Surface {
  std::array<int, 2> materials{};
  std::vector<std::uint64_t> first;   // [voxels + 1]
  std::vector<std::uint32_t> target;  // [pairs] voxel of materials[1]
  std::vector<double> area;           // [pairs] [m^2]
  std::vector<double> share;          // [pairs] of the row's area
};

struct Voxels {
  std::vector<double> volume;                   // [m^3], capacity: C = n/volume
  std::vector<std::uint16_t> material;          // index into scene::Scene::materials
  std::vector<std::array<double, 3>> position;  // [m]
  std::vector<JumpGraph> graphs;
  std::vector<std::shared_ptr<const UnlistedJumps>> unlisted;  // by graph, that is then empty; null: it is written down
  std::vector<int> graph_of_species;                           // index into graphs; -1: the species does not move
  std::vector<Exchange> exchanges;                             // ascending by (voxel, species)
  std::vector<Surface> surfaces;                               // of surface reactions
  std::size_t size() const { return volume.size(); }
  const Surface* surface(std::array<int, 2> materials) const {  // null: none such
    const auto found = std::ranges::find(surfaces, materials, &Surface::materials);
    return found == surfaces.end() ? nullptr : &*found;
  }
};

}  // namespace shmoo::rdme
