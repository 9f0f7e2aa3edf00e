#pragma once
// From a frame to the voxels of chemistry: one jump graph per distinct habitat, what the fluid carries, and the
// exchange with everything outside (sides, clamped materials, fluxes, sponges).
#include <optional>
#include <span>
#include <vector>

#include "base/box.hpp"
#include "coupling/frame.hpp"
#include "rdme/jump_graph.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"
#include "sph/clusters.hpp"
#include "sph/fill.hpp"
#include "sph/kernel.hpp"
#include "sph/skin_rows.hpp"
#include "sph/sponge.hpp"

namespace shmoo::coupling {

template <int D>
class Geometry {
 public:
  // The scene must outlive the geometry.
  Geometry(const scene::Scene& scene, const sph::Filling<D>& filling);

  // Whether any species is carried by the fluid.
  bool carries() const { return !carried_.empty(); }

  // Where nothing carries and the particles rest, pass a frame without drift.
  rdme::Voxels voxels(const Frame<D>& frame) const { return voxels(frame, {}); }

  // The same for samplers alone: jumps of these species [species] need not be listed where particles move on.
  rdme::Voxels voxels(const Frame<D>& frame, const std::vector<bool>& sampled) const;

  // What passes between voxels [m^3/s]: what the fluid carries, and a flow from fuller to emptier voxels that keeps
  // capacities near what the particles fill (it carries species along, so it changes no uniform concentration and
  // conserves all). In a steady frame only what the fluid carries, summed to zero in every voxel. The frame must have a
  // drift.
  rdme::JumpGraph carrying_graph(const Frame<D>& frame) const;

  // What the voxels fill at these places [m^D]: their lattice cell, or where they are jittered and stand their Voronoi
  // cell.
  std::vector<double> capacities(std::span<const base::Vec<D>> position) const;

  // What enters of a species through a side of the domain (2 axis + side) or, where that is negative, from the surface
  // of a material, less what leaves [molecules/s]; concentrations [molecules/m^3] by voxel, in the middle of the frame.
  double flux(const Frame<D>& frame, std::size_t species, int side, int material,
              const std::vector<double>& concentration) const;

  const std::vector<std::uint16_t>& material() const { return material_; }

 private:
  void find_habitats();
  // By voxel; vacant ones have a number of their own, of which nothing is known.
  std::vector<std::uint16_t> material_in(const Frame<D>& frame) const;
  bool listed(std::size_t habitat, const Frame<D>& frame, const std::vector<bool>& sampled) const;
  void add_graphs(const Frame<D>& frame, const std::vector<bool>& sampled, rdme::Voxels& voxels) const;
  rdme::HabitatGraph habitat_graph(const Frame<D>& frame, const rdme::Places<D>& places,
                                   const sph::NeighbourRows<D>& near, std::size_t habitat) const;
  double reach() const;  // [m] of the kernel
  std::shared_ptr<const sph::NeighbourRows<D>> rows(const Frame<D>& frame) const;
  rdme::PairWeights weights(const Frame<D>& frame) const;
  void relax(rdme::JumpGraph& graph, const std::vector<double>& held, const Frame<D>& frame) const;
  void add_boundary_exchanges(std::size_t species, const std::vector<rdme::Contact>& contacts,
                              rdme::Voxels& voxels) const;
  rdme::Exchange exchange_of(const scene::SpeciesBoundary& boundary, const rdme::Contact& contact, double volume) const;
  void add_sponge_exchanges(std::size_t species, rdme::Voxels& voxels) const;
  void add_surfaces(const rdme::Places<D>& places, rdme::Voxels& voxels) const;
  bool lives_in(std::size_t species, std::uint16_t material) const;

  const scene::Scene& scene_;
  base::Box<D> box_;
  std::vector<std::uint16_t> material_;  // [voxels]
  std::vector<base::Vec<D>> vacant_;
  sph::AnyKernel<D> kernel_;
  double cell_;  // [m^D] what a particle fills on the lattice
  mutable sph::SkinRows<D> moving_rows_;
  mutable sph::SkinLists<D, sph::Clusters<D>> moving_clusters_;
  std::vector<bool> carried_;  // [materials]; empty where nothing is carried
  std::vector<rdme::Habitat> habitats_;
  std::vector<std::optional<sph::Surface<D>>> surfaces_;  // by habitat: where it meets what is held
  std::vector<int> habitat_of_species_;                   // -1: neither diffuses nor is carried
};

extern template class Geometry<1>;
extern template class Geometry<2>;
extern template class Geometry<3>;

}  // namespace shmoo::coupling
