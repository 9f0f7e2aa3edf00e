#pragma once
// A habitat's graph with neighbour rows of its own.
#include "rdme/jump_graph.hpp"

namespace shmoo::rdme {

template <int D>
HabitatGraph habitat_graph(const Places<D>& places, const base::Box<D>& box, const sph::AnyKernel<D>& kernel,
                           double depth, const Habitat& habitat, PairWeights weights = PairWeights::kernel) {
  sph::NeighbourRows<D> rows;
  rows.build(places.position, box, std::visit([](const auto& k) { return k.reach(); }, kernel));
  rows.sort();
  return make_habitat_graph<D>(places, rows, box, kernel, depth, habitat, weights);
}

}  // namespace shmoo::rdme
