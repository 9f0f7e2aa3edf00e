#include "sph/neighbours.hpp"

namespace shmoo::sph {
namespace {

// Calls visit(j) for every partner j of i, in a fixed order.
template <int D, class Visit>
void each_partner(const Cells<D>& cells, std::span<const base::Vec<D>> x, const base::Box<D>& box, double cutoff,
                  std::size_t i, Visit visit) {
  std::array<std::size_t, 27> found;
  const std::size_t count = cells.around(cells.cell_of(x[i]), found);
  for (std::size_t c = 0; c < count; ++c) {
    for (const std::uint32_t j : cells.members(found[c])) {
      if (j != i && box.nearest(x[i] - x[j]).squaredNorm() < cutoff * cutoff) visit(j);
    }
  }
}

}  // namespace

template <int D>
void NeighbourRows<D>::build(std::span<const Vec> positions, const base::Box<D>& box, double cutoff) {
  const std::size_t n = positions.size();
  cells_.build(positions, box, cutoff);
  first_.assign(n + 1, 0);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t partners = 0;
    each_partner<D>(cells_, positions, box, cutoff, i, [&](std::uint32_t) { ++partners; });
    first_[i + 1] = partners;
  }
  for (std::size_t i = 0; i < n; ++i) first_[i + 1] += first_[i];
  index_.resize(first_[n]);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    std::uint64_t next = first_[i];
    each_partner<D>(cells_, positions, box, cutoff, i, [&](std::uint32_t j) { index_[next++] = j; });
  }
}

template class NeighbourRows<1>;
template class NeighbourRows<2>;
template class NeighbourRows<3>;

}  // namespace shmoo::sph
