#pragma once
// Neighbour rows that ascend, kept as long as they serve.
#include "sph/neighbours.hpp"
#include "sph/skin_lists.hpp"

namespace shmoo::sph {

template <int D>
struct SortedRows : NeighbourRows<D> {
  SortedRows(std::span<const base::Vec<D>> positions, const base::Box<D>& box, double cutoff) {
    this->build(positions, box, cutoff);
    this->sort();
  }
};

template <int D>
using SkinRows = SkinLists<D, SortedRows<D>>;

}  // namespace shmoo::sph
