#include "hydro/solid/total_lagrangian.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/error.hpp"
#include "hydro/lanes.hpp"

namespace shmoo::hydro {
namespace {

constexpr double reach = 2.1;      // [spacings] 12 neighbours in 2-D, 32 in 3-D
constexpr double balance = 4.0;    // of the hourglass energy
constexpr double courant = 0.6;    // of spacing/wave speed; the least stable Poisson's ratio allows 0.83
constexpr double tolerated = 1.5;  // stiffening that this leaves room for

// How much stiffer than at rest: the law's tangent grows at most as fast as these in tension and compression.
template <int D>
double stiffening(const base::Mat<D>& F, double J) {
  const double stretch = F.squaredNorm() / D, inverse = F.inverse().squaredNorm() / D;
  return std::max(1.5 * stretch - 0.5, J > 0.0 ? inverse : 1.0);
}

}  // namespace

template <int D>
TotalLagrangian<D>::TotalLagrangian(const Body<D>& body, const base::Box<D>& box)
    : rows_(make_reference_rows<D>(body.start, std::vector<double>(body.size(), body.volume), {}, box,
                                   reach * body.spacing)),
      strain_(body.size(), Mat::Zero()),
      pull_(body.size(), Mat::Zero()),
      hourglass_(body.size(), 0.0) {
  for (const Mat& correction : rows_.correction) moment_.push_back(correction.inverse().trace());
}

template <int D>
Deformation<D> TotalLagrangian<D>::deformation(std::size_t i) const {
  return {Mat::Identity() + strain_[i], 1.0};
}

template <int D>
void TotalLagrangian<D>::find_strain(const Body<D>& body) {
  double stiffest = 1.0;
  bool inverted = false;
#pragma omp parallel for schedule(static) reduction(max                      \
                                                    : stiffest) reduction(|| \
                                                                          : inverted) if (worth_threads(body.size()))
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Vec u = body.displacement[i];
    Mat sum = Mat::Zero();
    for (std::uint64_t p = rows_.first[i]; p < rows_.first[i + 1]; ++p)
      sum += (body.displacement[rows_.neighbour[p]] - u) * (rows_.steepness[p] * rows_.separation[p]).transpose();
    strain_[i] = sum * rows_.correction[i];
    const auto at = deformation(i);
    if (!(at.J() > 0.0)) {
      inverted = true;
      continue;
    }
    const Moduli moduli = body.moduli(i);
    hourglass_[i] = balance * moduli.shear / moment_[i];
    pull_[i] = ElasticPoint<D>(body.law, moduli, at).stress().P * rows_.correction[i] - hourglass_[i] * strain_[i];
    stiffest = std::max(stiffest, stiffening<D>(at.F, at.J()));
  }
  if (inverted) report_inversion(body);
  stiffening_ = stiffest;
}

template <int D>
void TotalLagrangian<D>::find_forces(Body<D>& body, double) {
  find_strain(body);
#pragma omp parallel for schedule(static) if (worth_threads(body.size()))
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Vec u = body.displacement[i];
    const Mat Q = pull_[i];
    const double h = hourglass_[i];
    Vec sum = Vec::Zero();
    for (std::uint64_t p = rows_.first[i]; p < rows_.first[i + 1]; ++p) {
      const std::size_t j = rows_.neighbour[p];
      const Vec pair = (Q + pull_[j]) * rows_.separation[p] + (h + hourglass_[j]) * (body.displacement[j] - u);
      sum += rows_.steepness[p] * pair;
    }
    body.force[i] = body.volume * sum;
  }
}

template <int D>
double TotalLagrangian<D>::step_limit(const Body<D>& body) const {
  return courant * body.spacing / (body.wave_speed() * std::sqrt(std::max(1.0, stiffening_ / tolerated)));
}

template <int D>
double TotalLagrangian<D>::energy(const Body<D>& body) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    double residual = 0.0;
    for (std::uint64_t p = rows_.first[i]; p < rows_.first[i + 1]; ++p) {
      const Vec moved = body.displacement[rows_.neighbour[p]] - body.displacement[i];
      residual += rows_.steepness[p] * (moved - strain_[i] * rows_.separation[p]).squaredNorm();
    }
    sum += ElasticPoint<D>(body.law, body.moduli(i), deformation(i)).energy() + 0.5 * hourglass_[i] * residual;
  }
  return body.volume * sum;
}

template <int D>
Stress<D> TotalLagrangian<D>::stress(const Body<D>& body, std::size_t particle) const {
  const auto at = deformation(particle);
  return cauchy(ElasticPoint<D>(body.law, body.moduli(particle), at).stress(), at);
}

template <int D>
double TotalLagrangian<D>::density(const Body<D>& body, std::size_t particle) const {
  return body.density / deformation(particle).J();
}

template <int D>
void TotalLagrangian<D>::report_inversion(const Body<D>& body) const {
  for (std::size_t i = 0; i < body.size(); ++i) {
    if (deformation(i).J() > 0.0) continue;
    const Vec at = body.start[i] + body.displacement[i];
    throw base::RunError(
        fmt::format("the solid {} was turned inside out at ({:g}) m: it is pressed or driven harder than its moduli "
                    "can bear; use a smaller load or speed, a stiffer solid or a smaller domain.spacing",
                    body.name, fmt::join(at, ", ")));
  }
  throw base::RunError(fmt::format("the motion of the solid {} is no number any more", body.name));
}

template class TotalLagrangian<2>;
template class TotalLagrangian<3>;

}  // namespace shmoo::hydro
