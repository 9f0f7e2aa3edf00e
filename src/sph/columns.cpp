#include "sph/columns.hpp"

#include <cmath>

namespace shmoo::sph {
namespace {

constexpr double most_columns = 512;  // along an axis
constexpr int layers_per_width = 4;

}  // namespace

template <int D>
std::size_t ColumnGrid<D>::columns() const {
  std::size_t product = 1;
  for (int a = 0; a < D - 1; ++a) product *= std::size_t(count[std::size_t(a)]);
  return product;
}

template <int D>
std::size_t ColumnGrid<D>::column(const base::Vec<D>& x) const {
  std::size_t column = 0;
  for (int a = D - 2; a >= 0; --a) column = column * std::size_t(count[std::size_t(a)]) + std::size_t(at(x[a], a));
  return column;
}

template <int D>
ColumnGrid<D> lay_columns(const base::Vec<D>& lower, const base::Vec<D>& upper, double width,
                          const std::array<bool, D>& periodic, double margin) {
  ColumnGrid<D> grid;
  for (int a = 0; a < D; ++a) {
    const double length = std::max(upper[a] - lower[a], 1e-3 * width);
    const double parts = a == D - 1 ? layers_per_width : 1, most = most_columns * parts * parts;
    const double inside = std::clamp(std::round(parts * length / width), 1.0, most);
    const double beyond = periodic[std::size_t(a)] ? std::ceil(margin * inside / length) : 0.0;
    grid.inverse_width[a] = inside / length;
    grid.lower[a] = lower[a] - beyond / grid.inverse_width[a];
    grid.count[std::size_t(a)] = int(inside + 2.0 * beyond);
  }
  return grid;
}

// By layers first (a stable counting sort), then along the last axis within each.
template <int D>
void Columns<D>::sort(const ColumnGrid<D>& grid, std::span<const base::Vec<D>> points) {
  grid_ = grid;
  const auto layers = std::size_t(grid.layers());
  first_.assign(grid.columns() * layers + 1, 0);
  layer_.resize(points.size());
  order_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    layer_[i] = std::uint32_t(grid.column(points[i]) * layers + std::size_t(grid.at(points[i][D - 1], D - 1)));
    ++first_[layer_[i] + 1];
  }
  for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
  for (std::size_t i = points.size(); i-- > 0;) order_[--first_[layer_[i] + 1]] = std::uint32_t(i);
  // first_[k + 1] has become the beginning of layer k.
  first_.erase(first_.begin());
  first_.push_back(std::uint32_t(points.size()));
  for (std::size_t k = 0; k + 1 < first_.size(); ++k) sort_layer(points, k);
}

template <int D>
void Columns<D>::sort_layer(std::span<const base::Vec<D>> points, std::size_t layer) {
  const auto begin = order_.begin() + std::ptrdiff_t(first_[layer]);
  const auto end = order_.begin() + std::ptrdiff_t(first_[layer + 1]);
  const auto below = [&](std::uint32_t i, std::uint32_t j) { return points[i][D - 1] < points[j][D - 1]; };
  if (!std::is_sorted(begin, end, below))
    std::sort(begin, end, [&](std::uint32_t i, std::uint32_t j) { return below(i, j) || (!below(j, i) && i < j); });
}

template struct ColumnGrid<1>;
template struct ColumnGrid<2>;
template struct ColumnGrid<3>;
template ColumnGrid<1> lay_columns<1>(const base::Vec<1>&, const base::Vec<1>&, double, const std::array<bool, 1>&,
                                      double);
template ColumnGrid<2> lay_columns<2>(const base::Vec<2>&, const base::Vec<2>&, double, const std::array<bool, 2>&,
                                      double);
template ColumnGrid<3> lay_columns<3>(const base::Vec<3>&, const base::Vec<3>&, double, const std::array<bool, 3>&,
                                      double);
template class Columns<1>;
template class Columns<2>;
template class Columns<3>;

}  // namespace shmoo::sph
