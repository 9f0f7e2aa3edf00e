#pragma once
// Neighbour rows: for every particle the others within a cutoff, in compressed rows. Directed: a pair stands in both
// rows.
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"
#include "sph/cells.hpp"

namespace shmoo::sph {

template <int D>
class NeighbourRows {
 public:
  using Vec = base::Vec<D>;

  // Pairs with distance < cutoff [m]; the order within a row depends on positions and indices only, not on threads.
  // Every periodic extent must be at least two cutoffs.
  void build(std::span<const Vec> positions, const base::Box<D>& box, double cutoff);

  // Makes the rows ascend.
  void sort();

  std::size_t size() const { return first_.empty() ? 0 : first_.size() - 1; }
  std::uint64_t first(std::size_t i) const { return first_[i]; }
  std::uint64_t pairs() const { return first_.empty() ? 0 : first_.back(); }
  std::span<const std::uint32_t> row(std::size_t i) const {
    return {index_.data() + first_[i], index_.data() + first_[i + 1]};
  }
  const Cells<D>& cells() const { return cells_; }

 private:
  Cells<D> cells_;
  std::vector<std::uint64_t> first_;
  std::vector<std::uint32_t> index_;
};

extern template class NeighbourRows<1>;
extern template class NeighbourRows<2>;
extern template class NeighbourRows<3>;

}  // namespace shmoo::sph
