#pragma once
// Jump rates between particles. The coupling c_ij = 2 s_ij V_j F_ij [1/m^2] obeys V_i c_ij = V_j c_ji, so every
// equilibrium has equal concentrations (thesis Eq. 2.28 with the missing 1/r, and per volume instead of per count).
// Where particles stand off their lattice, V_i c_ij is the weight of the Voronoi face between them instead
// (voronoi.hpp).
// * s_ij = (s_i + s_j)/2 is the second-moment scaling: 1/s_i = mu_own + mu_wall/2, mu = (1/D) sum_j V_j F_ij r_ij^2,
//   where particles that are no home of the species make up mu_wall.
// * At a reflecting side every particle has a mirror image, and a jump to an image is a jump to its particle: rates
//   stay positive and symmetric, and the operator keeps its second order up to the side.
// * At an open side (held concentration, absorbing) a particle at distance d exchanges molecules with the side at
//   max(0, sum_j c_ij (d_j - d_i))/d_i [1/m^2], which makes every linear profile exact on any arrangement.
// * At the surface of a clamped material the same holds with h(d) in place of d, the solution of Laplace's equation
//   about the plane, cylinder or ball that the true surface is there (sph/surface.hpp), where the caller gives it and
//   it is smooth; elsewhere the particles of the material are held at its value.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"
#include "rdme/voxels.hpp"
#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"
#include "sph/surface.hpp"

namespace shmoo::rdme {

enum class SideUse : std::uint8_t { reflect, flux, open };  // of a side that is not periodic

// Where a species lives and what its surroundings are.
struct Habitat {
  std::vector<bool> home;         // [materials]
  std::vector<bool> clamped;      // [materials] voxels held at a concentration: reached by jumps, not simulated
  std::vector<bool> source;       // [materials] no home, but its surface releases a flux
  std::vector<bool> carries;      // [materials] fluid that carries species along
  std::array<SideUse, 6> side{};  // [2 axis + side]
  bool operator==(const Habitat&) const = default;
};

// The particles at one moment, by id.
template <int D>
struct Places {
  std::span<const base::Vec<D>> position;  // [m]
  std::span<const double> area;            // [m^D] what the particle fills
  std::span<const base::Vec<D>> drift;     // [m/s] transport minus fluid velocity; empty: nothing is carried
  std::span<const std::uint16_t> material;
  std::span<const base::Vec<D>> vacant = {};  // [m] where no particle stands; bounds the Voronoi cells beside it
};

// A voxel's contact with a boundary: a side of the domain (2 axis + side) or the surface of a material (6 + material).
struct Contact {
  std::uint32_t voxel = 0;
  std::uint32_t boundary = 0;
  double exchange = 0;  // [1/m^2]; per-molecule exit rate = kappa * exchange; 0 at a flux boundary
  double area = 0;      // [m^2] the voxel's share of a flux boundary; 0 elsewhere
};

struct HabitatGraph {
  JumpGraph graph;
  std::vector<Contact> contacts;  // ascending by voxel
};

// Which pairs exchange molecules, and how readily: kernel weights of all pairs within reach, or the faces of Voronoi
// cells, which are exact for linear profiles on disordered particles but cost more to find.
enum class PairWeights : std::uint8_t { kernel, faces };

// `rows`: all pairs within the kernel's reach, and perhaps some beyond, ascending; the graph's rows ascend, too, as
// whoever compares those of two graphs expects. `depth` as in scene::Scene.
template <int D>
HabitatGraph make_habitat_graph(const Places<D>& places, const sph::NeighbourRows<D>& rows, const base::Box<D>& box,
                                const sph::AnyKernel<D>& kernel, double depth, const Habitat& habitat,
                                PairWeights weights = PairWeights::kernel, const sph::Surface<D>* surface = nullptr);

// Adds the smallest potential flow that makes the carried flow of every voxel sum to zero (to a relative 1e-12), so
// that a flow carried for ever leaves a uniform concentration alone. Returns the largest |net flow| before, relative to
// the largest gross flow. Throws base::RunError where the conjugate gradients fail.
double make_divergence_free(JumpGraph& graph, std::span<const double> volume);

extern template HabitatGraph make_habitat_graph(const Places<1>&, const sph::NeighbourRows<1>&, const base::Box<1>&,
                                                const sph::AnyKernel<1>&, double, const Habitat&, PairWeights,
                                                const sph::Surface<1>*);
extern template HabitatGraph make_habitat_graph(const Places<2>&, const sph::NeighbourRows<2>&, const base::Box<2>&,
                                                const sph::AnyKernel<2>&, double, const Habitat&, PairWeights,
                                                const sph::Surface<2>*);
extern template HabitatGraph make_habitat_graph(const Places<3>&, const sph::NeighbourRows<3>&, const base::Box<3>&,
                                                const sph::AnyKernel<3>&, double, const Habitat&, PairWeights,
                                                const sph::Surface<3>*);

}  // namespace shmoo::rdme
