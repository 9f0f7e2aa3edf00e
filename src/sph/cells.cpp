#include "sph/cells.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::sph {
namespace {

constexpr int most_cells_per_axis = 1024;

}  // namespace

template <int D>
void Cells<D>::build(std::span<const Vec> positions, const base::Box<D>& box, double width) {
  Vec lower = box.lower, upper = box.upper;
  for (const Vec& x : positions) {
    lower = lower.cwiseMin(x);
    upper = upper.cwiseMax(x);
  }
  std::size_t total = 1;
  for (int a = 0; a < D; ++a) {
    periodic_[a] = box.periodic[a];
    lower_[a] = periodic_[a] ? box.lower[a] : lower[a];
    const double length = (periodic_[a] ? box.upper[a] : upper[a]) - lower_[a];
    count_[a] = static_cast<int>(std::clamp(std::floor(length / width), 1.0, double(most_cells_per_axis)));
    inverse_width_[a] = length > 0.0 ? count_[a] / length : 0.0;
    total *= static_cast<std::size_t>(count_[a]);
  }
  first_.assign(total + 1, 0);
  cell_.resize(positions.size());
  order_.resize(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    cell_[i] = static_cast<std::uint32_t>(cell_of(positions[i]));
    ++first_[cell_[i] + 1];
  }
  for (std::size_t c = 0; c < total; ++c) first_[c + 1] += first_[c];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < positions.size(); ++i) order_[next[cell_[i]]++] = static_cast<std::uint32_t>(i);
}

template <int D>
int Cells<D>::coordinate(double x, int axis) const {
  const double c = std::floor((x - lower_[axis]) * inverse_width_[axis]);
  return static_cast<int>(std::clamp(c, 0.0, double(count_[axis] - 1)));
}

template <int D>
std::size_t Cells<D>::cell_of(const Vec& position) const {
  std::size_t cell = 0;
  for (int a = D - 1; a >= 0; --a) {
    cell = cell * static_cast<std::size_t>(count_[a]) + static_cast<std::size_t>(coordinate(position[a], a));
  }
  return cell;
}

template <int D>
std::size_t Cells<D>::around(std::size_t cell, std::array<std::size_t, 27>& found) const {
  std::size_t size = 1, stride = 1, rest = cell;
  found[0] = 0;
  for (int a = 0; a < D; ++a) {
    const int n = count_[a];
    const int here = static_cast<int>(rest % static_cast<std::size_t>(n));
    rest /= static_cast<std::size_t>(n);
    std::array<int, 3> along{};
    std::size_t kept = 0;
    for (int shift = -1; shift <= 1; ++shift) {
      int c = here + shift;
      if (periodic_[a])
        c = (c + n) % n;
      else if (c < 0 || c >= n)
        continue;
      if (std::find(along.begin(), along.begin() + kept, c) == along.begin() + kept) along[kept++] = c;
    }
    for (std::size_t k = kept; k-- > 0;) {
      for (std::size_t f = 0; f < size; ++f)
        found[k * size + f] = found[f] + static_cast<std::size_t>(along[k]) * stride;
    }
    size *= kept;
    stride *= static_cast<std::size_t>(n);
  }
  return size;
}

template class Cells<1>;
template class Cells<2>;
template class Cells<3>;

}  // namespace shmoo::sph
