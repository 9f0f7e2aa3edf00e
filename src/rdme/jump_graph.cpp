#include "rdme/jump_graph.hpp"

#include "rdme/contacts.hpp"
#include "rdme/kernel_graph.hpp"
#include "rdme/voronoi.hpp"

namespace shmoo::rdme {
namespace {

template <int D>
JumpGraph face_graph(const Surroundings<D>& around) {
  const auto& places = around.places;
  const double points = double(places.position.size() + places.vacant.size());
  const auto cells =
      voronoi_cells<D>(places.position, places.vacant, around.box, std::pow(around.box.volume() / points, 1.0 / D));
  JumpGraph graph;
  graph.first.push_back(0);
  for (std::size_t i = 0; i < around.size(); ++i) {
    for (std::uint64_t f = cells.first[i]; around.is_home(i) && f < cells.first[i + 1]; ++f) {
      const std::uint32_t j = cells.target[f];
      const double coupling = cells.weight[f] / places.area[i];
      if (j == i || coupling <= 0.0 || !(around.is_home(j) || around.is_clamped(j))) continue;
      graph.target.push_back(j);
      graph.coupling.push_back(coupling);
      if (!places.drift.empty()) graph.flow.push_back(around.flow(i, j, 0u, around.separation(i, j), coupling));
    }
    graph.first.push_back(graph.target.size());
  }
  return graph;
}

}  // namespace

template <int D>
HabitatGraph make_habitat_graph(const Places<D>& places, const sph::NeighbourRows<D>& rows, const base::Box<D>& box,
                                const sph::AnyKernel<D>& kernel, double depth, const Habitat& habitat,
                                PairWeights weights, const sph::Surface<D>* surface) {
  const Surroundings<D> around{places, box, kernel, depth, habitat, rows, surface};
  return with_contacts(around, weights == PairWeights::faces ? face_graph(around) : kernel_graph(around));
}

template HabitatGraph make_habitat_graph(const Places<1>&, const sph::NeighbourRows<1>&, const base::Box<1>&,
                                         const sph::AnyKernel<1>&, double, const Habitat&, PairWeights,
                                         const sph::Surface<1>*);
template HabitatGraph make_habitat_graph(const Places<2>&, const sph::NeighbourRows<2>&, const base::Box<2>&,
                                         const sph::AnyKernel<2>&, double, const Habitat&, PairWeights,
                                         const sph::Surface<2>*);
template HabitatGraph make_habitat_graph(const Places<3>&, const sph::NeighbourRows<3>&, const base::Box<3>&,
                                         const sph::AnyKernel<3>&, double, const Habitat&, PairWeights,
                                         const sph::Surface<3>*);

}  // namespace shmoo::rdme
