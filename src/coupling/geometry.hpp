#pragma once
// From a frame to the voxels of chemistry: one jump graph per distinct habitat, what the fluid carries, and the
// exchange with everything outside (sides, clamped materials, fluxes, sponges).
#include <vector>

#include "base/box.hpp"
#include "coupling/frame.hpp"
#include "rdme/jump_graph.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"
#include "sph/kernel.hpp"
#include "sph/sponge.hpp"

namespace shmoo::coupling {

template <int D>
class Geometry {
 public:
  // `material` by voxel. The scene must outlive the geometry.
  Geometry(const scene::Scene& scene, const base::Box<D>& box, std::vector<std::uint16_t> material, double reach);

  // Whether any species is carried by the fluid.
  bool carries() const { return !carried_.empty(); }

  // Where nothing carries and the particles rest, pass a frame without drift.
  rdme::Voxels voxels(const Frame<D>& frame) const;

  // What the fluid carries between voxels [m^3/s] for areas as given; flow summed to zero where `steady`.
  rdme::JumpGraph carrying_graph(const std::vector<base::Vec<D>>& position, const std::vector<double>& capacity,
                                 const std::vector<base::Vec<D>>& drift, bool steady) const;

  const std::vector<std::uint16_t>& material() const { return material_; }

 private:
  void find_habitats();
  void add_boundary_exchanges(std::size_t species, const rdme::HabitatGraph& graph, rdme::Voxels& voxels) const;
  void add_sponge_exchanges(std::size_t species, rdme::Voxels& voxels) const;
  bool lives_in(std::size_t species, std::uint16_t material) const;

  const scene::Scene& scene_;
  base::Box<D> box_;
  std::vector<std::uint16_t> material_;
  sph::AnyKernel<D> kernel_;
  std::vector<bool> carried_;  // [materials]; empty where nothing is carried
  std::vector<rdme::Habitat> habitats_;
  std::vector<int> habitat_of_species_;  // -1: neither diffuses nor is carried
};

extern template class Geometry<1>;
extern template class Geometry<2>;
extern template class Geometry<3>;

}  // namespace shmoo::coupling
