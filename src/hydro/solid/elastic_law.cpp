#include "hydro/solid/elastic_law.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace shmoo::hydro {
namespace {

template <int D>
Strains<D> as_vector(const base::Mat<D>& F, double hoop) {
  Strains<D> all;
  all.template head<D * D>() = Eigen::Map<const Eigen::Matrix<double, D * D, 1>>(F.data());
  if constexpr (D == 2) all[4] = hoop;
  return all;
}

// Green's strain E = (F^T F - I)/2, and that of the hoop.
template <int D>
Deformation<D> green(const Deformation<D>& at) {
  return {0.5 * (at.F.transpose() * at.F - base::Mat<D>::Identity()), D == 2 ? 0.5 * (at.hoop * at.hoop - 1.0) : 0.0};
}

}  // namespace

Moduli moduli(double shear, double poisson_ratio) {
  return {shear, 2.0 * shear * (1.0 + poisson_ratio) / (3.0 * (1.0 - 2.0 * poisson_ratio))};
}

double softened(double shear, const scene::Softening& softening, double concentration) {
  return shear * std::clamp(1.0 - softening.coefficient * concentration, softening.least, 1.0);
}

template <int D>
ElasticPoint<D>::ElasticPoint(scene::ElasticLaw law, const Moduli& moduli, const Deformation<D>& deformation)
    : law_(law), moduli_(moduli), at_(deformation), J_(deformation.J()) {
  if (!(J_ > 0.0) || (D == 2 && !(at_.hoop > 0.0))) throw base::RunError("an elastic solid has been turned inside out");
  inverse_ = at_.F.inverse();
  I1_ = at_.F.squaredNorm() + (D == 2 ? at_.hoop * at_.hoop : 0.0);
}

template <int D>
double ElasticPoint<D>::energy() const {
  const auto [G, K] = moduli_;
  if (law_ == scene::ElasticLaw::neo_hookean) {
    return 0.5 * G * (I1_ / std::cbrt(J_ * J_) - 3.0) + 0.25 * K * (J_ * J_ - 1.0 - 2.0 * std::log(J_));
  }
  const auto E = green(at_);
  const double trace = E.F.trace() + E.hoop;
  return G * (E.F.squaredNorm() + E.hoop * E.hoop) + (0.5 * K - G / 3.0) * trace * trace;
}

template <int D>
Strains<D> ElasticPoint<D>::log_volume() const {
  return as_vector<D>(inverse_.transpose(), 1.0 / at_.hoop);
}

template <int D>
Tangent<D> ElasticPoint<D>::log_volume2() const {
  Tangent<D> second = Tangent<D>::Zero();
  for (int a = 0; a < D; ++a) {
    for (int b = 0; b < D; ++b) {
      for (int c = 0; c < D; ++c) {
        for (int d = 0; d < D; ++d) second(a + D * b, c + D * d) = -inverse_(b, c) * inverse_(d, a);
      }
    }
  }
  if constexpr (D == 2) second(4, 4) = -1.0 / (at_.hoop * at_.hoop);
  return second;
}

template <int D>
Strains<D> ElasticPoint<D>::first() const {
  const auto [G, K] = moduli_;
  if (law_ == scene::ElasticLaw::neo_hookean) {
    return G / std::cbrt(J_ * J_) * (as_vector<D>(at_.F, at_.hoop) - I1_ / 3.0 * log_volume()) +
           0.5 * K * (J_ * J_ - 1.0) * log_volume();
  }
  const auto E = green(at_);
  const double pressure = (K - 2.0 * G / 3.0) * (E.F.trace() + E.hoop);
  const base::Mat<D> P = at_.F * (2.0 * G * E.F + pressure * base::Mat<D>::Identity());
  return as_vector<D>(P, at_.hoop * (2.0 * G * E.hoop + pressure));
}

template <int D>
Stress<D> ElasticPoint<D>::stress() const {
  const Strains<D> all = first();
  Stress<D> stress;
  stress.P = Eigen::Map<const base::Mat<D>>(all.data());
  if constexpr (D == 2) stress.hoop = all[4];
  return stress;
}

template <int D>
Tangent<D> ElasticPoint<D>::neo_hookean_tangent() const {
  const auto [G, K] = moduli_;
  const Strains<D> y = as_vector<D>(at_.F, at_.hoop), h = log_volume();
  const double g = G / std::cbrt(J_ * J_);
  const Tangent<D> mixed = y * h.transpose();
  return g * (Tangent<D>::Identity() - 2.0 / 3.0 * (mixed + mixed.transpose())) +
         (g * 2.0 / 9.0 * I1_ + K * J_ * J_) * h * h.transpose() +
         (0.5 * K * (J_ * J_ - 1.0) - g * I1_ / 3.0) * log_volume2();
}

template <int D>
Tangent<D> ElasticPoint<D>::kirchhoff_tangent() const {
  const auto [G, K] = moduli_;
  const double lambda = K - 2.0 * G / 3.0;
  const auto E = green(at_);
  const double pressure = lambda * (E.F.trace() + E.hoop);
  const base::Mat<D> S = 2.0 * G * E.F + pressure * base::Mat<D>::Identity();
  Tangent<D> all = Tangent<D>::Zero();
  for (int c = 0; c < D; ++c) {
    for (int d = 0; d < D; ++d) {
      base::Mat<D> dF = base::Mat<D>::Zero();
      dF(c, d) = 1.0;
      const base::Mat<D> half = at_.F.transpose() * dF, dE = 0.5 * (half + half.transpose());
      const base::Mat<D> dP = dF * S + at_.F * (2.0 * G * dE + lambda * dE.trace() * base::Mat<D>::Identity());
      all.col(c + D * d) = as_vector<D>(dP, at_.hoop * lambda * dE.trace());
    }
  }
  if constexpr (D == 2) {
    const double dE = at_.hoop;
    all.col(4) = as_vector<D>(lambda * dE * at_.F, 2.0 * G * E.hoop + pressure + at_.hoop * (2.0 * G + lambda) * dE);
  }
  return all;
}

template <int D>
Tangent<D> ElasticPoint<D>::tangent() const {
  return law_ == scene::ElasticLaw::neo_hookean ? neo_hookean_tangent() : kirchhoff_tangent();
}

template <int D>
Stress<D> cauchy(const Stress<D>& piola, const Deformation<D>& at) {
  return {piola.P * at.F.transpose() / at.J(), piola.hoop * at.hoop / at.J()};
}

template class ElasticPoint<2>;
template class ElasticPoint<3>;
template Stress<2> cauchy(const Stress<2>&, const Deformation<2>&);
template Stress<3> cauchy(const Stress<3>&, const Deformation<3>&);

}  // namespace shmoo::hydro
