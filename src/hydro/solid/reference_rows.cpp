#include "hydro/solid/reference_rows.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "base/error.hpp"
#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::hydro {
namespace {

constexpr double flat = 1e-6;  // smallest to largest moment of a neighbourhood that counts as spanning space

template <int D>
[[noreturn]] void refuse(const base::Vec<D>& at, double reach, std::size_t found) {
  throw base::InputError(fmt::format(
      "a solid's particle at ({}) m has {} neighbours within {:g} m, and they do not span {} dimensions, so that "
      "strain has no meaning there; make the solid at least two particles thick by a smaller spacing",
      fmt::join(at, ", "), found, reach, D));
}

}  // namespace

template <int D>
ReferenceRows<D> make_reference_rows(std::span<const base::Vec<D>> X, std::span<const double> volume,
                                     std::span<const std::uint16_t> body, const base::Box<D>& box, double reach) {
  sph::NeighbourRows<D> near;
  near.build(X, box, reach);
  const sph::WendlandC2<D> kernel(reach);
  ReferenceRows<D> rows;
  rows.first.push_back(0);
  for (std::size_t i = 0; i < X.size(); ++i) {
    const std::size_t begin = rows.neighbour.size();
    base::Mat<D> moment = base::Mat<D>::Zero();
    double total = 0.0;
    for (const std::uint32_t j : near.row(i)) {
      if (!body.empty() && body[i] != body[j]) continue;
      const base::Vec<D> apart = box.nearest(X[j] - X[i]);
      const double r = apart.norm(), w = volume[j] * kernel.W(r);
      rows.neighbour.push_back(j);
      rows.separation.push_back(apart);
      rows.steepness.push_back(volume[j] * kernel.F(r));
      rows.gradient.push_back(rows.steepness.back() * apart);
      rows.weight.push_back(w);
      moment += rows.gradient.back() * apart.transpose();
      total += w;
    }
    const auto spread = Eigen::SelfAdjointEigenSolver<base::Mat<D>>(moment, Eigen::EigenvaluesOnly).eigenvalues();
    if (!(spread[0] > flat * spread[D - 1])) refuse<D>(X[i], reach, rows.neighbour.size() - begin);
    const base::Mat<D> correction = moment.inverse();
    rows.correction.push_back(correction);
    for (std::size_t p = begin; p < rows.neighbour.size(); ++p) {
      rows.gradient[p] = correction * rows.gradient[p];
      rows.weight[p] /= total;
    }
    rows.first.push_back(rows.neighbour.size());
  }
  return rows;
}

template ReferenceRows<2> make_reference_rows(std::span<const base::Vec<2>>, std::span<const double>,
                                              std::span<const std::uint16_t>, const base::Box<2>&, double);
template ReferenceRows<3> make_reference_rows(std::span<const base::Vec<3>>, std::span<const double>,
                                              std::span<const std::uint16_t>, const base::Box<3>&, double);

}  // namespace shmoo::hydro
