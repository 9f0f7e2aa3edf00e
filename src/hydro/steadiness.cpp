#include "hydro/steadiness.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace shmoo::hydro {
namespace {

// Sums of a least-squares fit of v = a + G y, y the place relative to the cell's centre in widths.
template <int D>
struct Fit {
  Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  Eigen::Matrix<double, D + 1, D> right = Eigen::Matrix<double, D + 1, D>::Zero();
  int count = 0;
};

}  // namespace

template <int D>
Steadiness<D>::Steadiness(const Fluid<D>& fluid) : box_(fluid.box()) {
  for (int a = 0; a < D; ++a) {
    const double extent = box_.upper[a] - box_.lower[a];
    cells_[std::size_t(a)] =
        std::max<std::size_t>(1, std::size_t(std::lround(extent / (2.0 * fluid.scales().smoothing))));
    width_[a] = extent / double(cells_[std::size_t(a)]);
  }
}

template <int D>
std::vector<base::Vec<D>> Steadiness<D>::sample(const Fluid<D>& fluid) const {
  std::size_t total = 1;
  for (const std::size_t count : cells_) total *= count;
  std::vector<Fit<D>> fits(total);
  for (const std::uint32_t i : fluid.state().rows.fluid()) {
    Eigen::Matrix<double, D + 1, 1> basis;
    basis[0] = 1.0;
    std::size_t cell = 0;
    for (int a = D - 1; a >= 0; --a) {
      const double place = (fluid.particles().position[i][a] - box_.lower[a]) / width_[a];
      const double index = std::clamp(std::floor(place), 0.0, double(cells_[std::size_t(a)] - 1));
      cell = cell * cells_[std::size_t(a)] + std::size_t(index);
      basis[a + 1] = place - index - 0.5;
    }
    fits[cell].normal += basis * basis.transpose();
    fits[cell].right += basis * fluid.state().velocity[i].transpose();
    ++fits[cell].count;
  }
  std::vector<base::Vec<D>> velocities(total, base::Vec<D>::Constant(unknown));
  for (std::size_t c = 0; c < total; ++c) {
    if (fits[c].count < 2 * (D + 1)) continue;
    velocities[c] = fits[c].normal.ldlt().solve(fits[c].right).row(0).transpose();
  }
  return velocities;
}

template <int D>
double Steadiness<D>::measure(const Fluid<D>& fluid) {
  auto now = sample(fluid);
  const double elapsed = fluid.time() - last_time_;
  double change = 0.0, size = 0.0;
  for (std::size_t c = 0; c < last_.size(); ++c) {
    if (std::isnan(now[c][0]) || std::isnan(last_[c][0])) continue;
    change += (now[c] - last_[c]).squaredNorm();
    size += now[c].squaredNorm();
  }
  last_ = std::move(now);
  last_time_ = fluid.time();
  if (!(elapsed > 0.0) || !(size > 0.0)) return std::numeric_limits<double>::infinity();
  return std::sqrt(change / size) * (fluid.scales().length / fluid.scales().speed) / elapsed;
}

template class Steadiness<2>;
template class Steadiness<3>;

}  // namespace shmoo::hydro
