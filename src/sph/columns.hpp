#pragma once
// Points sorted into columns along the last axis and, within a column, along it: those that follow each other stand
// close together, and what lies near a box is one range of each column about it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace shmoo::sph {

// How space is cut: columns of a square cross-section, and layers across them.
template <int D>
struct ColumnGrid {
  base::Vec<D> lower = base::Vec<D>::Zero();          // [m] where the first column and layer begin
  base::Vec<D> inverse_width = base::Vec<D>::Zero();  // [1/m] of columns and, last, of layers
  std::array<int, D> count{};

  int at(double x, int axis) const {
    return std::clamp(int((x - lower[axis]) * inverse_width[axis]), 0, count[std::size_t(axis)] - 1);
  }
  std::size_t columns() const;
  int layers() const { return count[D - 1]; }
  std::size_t column(const base::Vec<D>& x) const;
};

// Columns about `width` wide over the extent; where an axis is periodic with a length, they fill it evenly.
template <int D>
ColumnGrid<D> lay_columns(const base::Vec<D>& lower, const base::Vec<D>& upper, double width,
                          const std::array<bool, D>& periodic, double margin);

template <int D>
class Columns {
 public:
  void sort(const ColumnGrid<D>& grid, std::span<const base::Vec<D>> points);

  // Points in the order of columns and layers; within a layer along the last axis.
  std::span<const std::uint32_t> order() const { return order_; }
  // A column's points are first(c) .. first(c + 1) of the order.
  std::uint32_t first(std::size_t column) const { return first_[column * std::size_t(grid_.layers())]; }

  // Calls visit(column, begin, end) for all ranges of the order that can hold points within `distance` of the box.
  template <class Visit>
  void visit(const base::Vec<D>& lower, const base::Vec<D>& upper, double distance, Visit&& visit) const {
    if constexpr (D == 1) return visit_column(0, lower[0] - distance, upper[0] + distance, visit);
    const int x0 = grid_.at(lower[0] - distance, 0), x1 = grid_.at(upper[0] + distance, 0);
    for (int x = x0; x <= x1; ++x) {
      const double rest = within(distance, gap(lower, upper, 0, x));
      if constexpr (D == 2) {
        visit_column(std::size_t(x), lower[1] - rest, upper[1] + rest, visit);
      } else if constexpr (D == 3) {
        const int y0 = grid_.at(lower[1] - rest, 1), y1 = grid_.at(upper[1] + rest, 1);
        for (int y = y0; y <= y1; ++y) {
          const double along = within(rest, gap(lower, upper, 1, y));
          const auto column = std::size_t(y) * std::size_t(grid_.count[0]) + std::size_t(x);
          visit_column(column, lower[2] - along, upper[2] + along, visit);
        }
      }
    }
  }

 private:
  // [m] between the box and the k-th columns along an axis; the outermost ones have no end.
  double gap(const base::Vec<D>& lower, const base::Vec<D>& upper, int axis, int k) const {
    const double width = 1.0 / grid_.inverse_width[axis], left = grid_.lower[axis] + k * width;
    const double before = k > 0 ? left - upper[axis] : 0.0;
    const double after = k + 1 < grid_.count[std::size_t(axis)] ? lower[axis] - (left + width) : 0.0;
    return std::max({before, after, 0.0});
  }
  static double within(double distance, double gap) {
    return std::sqrt(std::max(distance * distance - gap * gap, 0.0));
  }
  template <class Visit>
  void visit_column(std::size_t column, double from, double to, Visit&& visit) const {
    const std::uint32_t* first = first_.data() + column * std::size_t(grid_.layers());
    const std::uint32_t begin = first[grid_.at(from, D - 1)], end = first[grid_.at(to, D - 1) + 1];
    if (begin < end) visit(column, begin, end);
  }
  void sort_layer(std::span<const base::Vec<D>> points, std::size_t layer);

  ColumnGrid<D> grid_;
  std::vector<std::uint32_t> first_, order_, layer_;
};

extern template struct ColumnGrid<1>;
extern template struct ColumnGrid<2>;
extern template struct ColumnGrid<3>;
extern template class Columns<1>;
extern template class Columns<2>;
extern template class Columns<3>;

}  // namespace shmoo::sph
