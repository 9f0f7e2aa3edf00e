#include "sph/neighbours.hpp"

#include <algorithm>

namespace shmoo::sph {
namespace {

// All that may be partners of one cell's particles, coordinate by coordinate, so that distances become vector code.
template <int D>
class Crowd {
 public:
  void gather(const Cells<D>& cells, std::span<const base::Vec<D>> positions, std::size_t cell) {
    std::array<std::size_t, 27> around;
    const std::size_t count = cells.around(cell, around);
    index_.clear();
    for (std::size_t c = 0; c < count; ++c) {
      const auto members = cells.members(around[c]);
      index_.insert(index_.end(), members.begin(), members.end());
    }
    distance_.resize(index_.size());
    for (int a = 0; a < D; ++a) {
      x_[std::size_t(a)].resize(index_.size());
      for (std::size_t k = 0; k < index_.size(); ++k) x_[std::size_t(a)][k] = positions[index_[k]][a];
    }
  }

  // Appends the partners of particle i, which stands at x, and returns their number.
  std::uint32_t append_partners(std::size_t i, const base::Vec<D>& x, const base::Box<D>& box, double cutoff,
                                std::vector<std::uint32_t>& partners) {
    std::fill(distance_.begin(), distance_.end(), 0.0);
    for (int a = 0; a < D; ++a) add_squares(x[a], a, box);
    const std::size_t before = partners.size();
    partners.resize(before + index_.size());
    std::uint32_t* const row = partners.data() + before;
    std::uint32_t found = 0;
    for (std::size_t k = 0; k < index_.size(); ++k) {
      row[found] = index_[k];
      found += distance_[k] < cutoff * cutoff && index_[k] != i ? 1U : 0U;
    }
    partners.resize(before + found);
    return found;
  }

 private:
  void add_squares(double x, int axis, const base::Box<D>& box) {
    const double length = box.upper[axis] - box.lower[axis], half = 0.5 * length;
    const double image = box.periodic[std::size_t(axis)] ? length : 0.0;
    const double* const other = x_[std::size_t(axis)].data();
    double* const squares = distance_.data();
    for (std::size_t k = 0; k < index_.size(); ++k) {
      double d = x - other[k];
      d = d > half ? d - image : d < -half ? d + image : d;
      squares[k] += d * d;
    }
  }

  std::vector<std::uint32_t> index_;
  std::array<std::vector<double>, D> x_;
  std::vector<double> distance_;  // squared
};

}  // namespace

template <int D>
void NeighbourRows<D>::build(std::span<const Vec> positions, const base::Box<D>& box, double cutoff) {
  const std::size_t n = positions.size();
  cells_.build(positions, box, cutoff);
  first_.assign(n + 1, 0);
  std::vector<std::vector<std::uint32_t>> found(cells_.cells());  // of a cell's particles, one after the other
#pragma omp parallel
  {
    Crowd<D> crowd;
#pragma omp for schedule(dynamic, 8)
    for (std::size_t c = 0; c < found.size(); ++c) {
      if (cells_.members(c).empty()) continue;
      crowd.gather(cells_, positions, c);
      for (const std::uint32_t i : cells_.members(c))
        first_[i + 1] = crowd.append_partners(i, positions[i], box, cutoff, found[c]);
    }
  }
  for (std::size_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
  index_.resize(first_[n]);
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < found.size(); ++c) {
    auto from = found[c].begin();
    for (const std::uint32_t i : cells_.members(c)) {
      const auto size = static_cast<std::ptrdiff_t>(first_[i + 1] - first_[i]);
      std::copy(from, from + size, index_.begin() + static_cast<std::ptrdiff_t>(first_[i]));
      from += size;
    }
  }
}

template <int D>
void NeighbourRows<D>::sort() {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < size(); ++i)
    std::sort(index_.begin() + std::ptrdiff_t(first_[i]), index_.begin() + std::ptrdiff_t(first_[i + 1]));
}

template class NeighbourRows<1>;
template class NeighbourRows<2>;
template class NeighbourRows<3>;

}  // namespace shmoo::sph
