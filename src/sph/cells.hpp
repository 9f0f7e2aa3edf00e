#pragma once
// Particles sorted into cells at least as wide as the search radius, so that all partners of a particle lie in its cell
// and the cells around it. Periodic axes with fewer than three cells are searched once, not twice.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"

namespace shmoo::sph {

template <int D>
class Cells {
 public:
  using Vec = base::Vec<D>;

  // Positions outside the box along an axis that is not periodic are welcome; along a periodic axis they must be
  // wrapped.
  void build(std::span<const Vec> positions, const base::Box<D>& box, double width);

  std::size_t cells() const { return first_.empty() ? 0 : first_.size() - 1; }
  std::span<const std::uint32_t> members(std::size_t cell) const {
    return {order_.data() + first_[cell], order_.data() + first_[cell + 1]};
  }
  // All particles in the order of their cells (a permutation of 0 .. N-1); within a cell ascending.
  std::span<const std::uint32_t> order() const { return order_; }
  std::size_t cell_of(const Vec& position) const;

  // The cells that may hold partners of what is in `cell`, itself included, each once. Returns how many.
  std::size_t around(std::size_t cell, std::array<std::size_t, 27>& found) const;

 private:
  int coordinate(double x, int axis) const;

  std::array<int, D> count_{};
  std::array<bool, D> periodic_{};
  Vec lower_ = Vec::Zero(), inverse_width_ = Vec::Zero();
  std::vector<std::uint32_t> first_, order_, cell_;
};

extern template class Cells<1>;
extern template class Cells<2>;
extern template class Cells<3>;

}  // namespace shmoo::sph
