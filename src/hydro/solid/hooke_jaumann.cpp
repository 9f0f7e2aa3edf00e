#include "hydro/solid/hooke_jaumann.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "hydro/lanes.hpp"

namespace shmoo::hydro {
namespace {

constexpr double courant = 0.25;       // of hs/wave speed
constexpr double least_moment = 1e-3;  // least over largest pivot of the moments that are still inverted
constexpr double most_strain = 0.5;    // of the density that is still an elastic body's

// The part of the stress that pulls, turned to push.
template <int D>
base::Mat<D> against_tension(const base::Mat<D>& sigma, double strength) {
  const Eigen::SelfAdjointEigenSolver<base::Mat<D>> axes(sigma);
  const base::Vec<D> push = -strength * axes.eigenvalues().cwiseMax(0.0);
  return axes.eigenvectors() * push.asDiagonal() * axes.eigenvectors().transpose();
}

// The first D rows of the moments' inverse: of the quadratic fit, else (a sheet of two layers) of the linear one, else
// (a row of particles) none.
template <int D, int N>
Eigen::Matrix<double, D, N> fit_of(const Eigen::Matrix<double, N, N>& moments) {
  Eigen::Matrix<double, D, N> fit = Eigen::Matrix<double, D, N>::Identity();
  const auto sound = [](const auto& factors) {
    const auto pivots = factors.vectorD();
    return pivots.minCoeff() > least_moment * pivots.maxCoeff();
  };
  const Eigen::LDLT<Eigen::Matrix<double, N, N>> whole(moments);
  if (sound(whole)) return whole.solve(Eigen::Matrix<double, N, N>::Identity()).template topRows<D>();
  const Eigen::LDLT<base::Mat<D>> linear(base::Mat<D>(moments.template topLeftCorner<D, D>()));
  if (sound(linear)) fit.template leftCols<D>() = linear.solve(base::Mat<D>::Identity());
  return fit;
}

}  // namespace

template <int D>
HookeJaumann<D>::HookeJaumann(const Body<D>& body, const base::Box<D>& box, const scene::Elastic& elastic,
                              const scene::Numerics& numerics)
    : box_(box),
      kernel_(sph::make_kernel<D>(numerics.kernel, numerics.reach * body.spacing)),
      reach_(numerics.reach * body.spacing),
      skin_(0.3 * body.spacing),
      artificial_stress_(elastic.artificial_stress),
      viscosity_(elastic.artificial_viscosity),
      density_(body.size(), body.density),
      compression_(body.size(), 1.0),
      deviator_(body.size(), Mat::Zero()),
      fit_(body.size()),
      pull_(body.size()),
      repulsion_(body.size(), Mat::Zero()) {}

template <int D>
double HookeJaumann<D>::pressure(const Body<D>& body, std::size_t i) const {
  return body.bulk * (density_[i] / body.density - 1.0);
}

// In half reaches, times one so that linear terms keep their unit [m].
template <int D>
typename HookeJaumann<D>::Terms HookeJaumann<D>::p(const Vec& x) const {
  Terms all;
  all.template head<D>() = x;
  int n = D;
  for (int a = 0; a < D; ++a)
    for (int b = a; b < D; ++b) all[n++] = x[a] * x[b] * (2.0 / reach_);
  return all;
}

// Positions now, and pairs where particles have moved half the skin.
template <int D>
void HookeJaumann<D>::follow(const Body<D>& body) {
  position_.resize(body.size());
  bool outdated = listed_at_.empty();
  for (std::size_t i = 0; i < body.size(); ++i) {
    position_[i] = box_.wrap(body.start[i] + body.displacement[i]);
    if (!outdated) outdated = !(box_.nearest(position_[i] - listed_at_[i]).squaredNorm() < 0.25 * skin_ * skin_);
  }
  if (!outdated) return;
  for (const Vec& x : position_)
    if (!x.allFinite())
      throw base::RunError(fmt::format("the motion of the solid {} is no number any more", body.name));
  rows_.build(position_, box_, reach_ + skin_);
  listed_at_ = position_;
}

template <int D>
template <class Kernel>
void HookeJaumann<D>::strain(const Body<D>& body, const Kernel& kernel, double dt) {
  const double mass = body.mass();
#pragma omp parallel for schedule(static) if (worth_threads(body.size()))
  for (std::size_t i = 0; i < body.size(); ++i) {
    Eigen::Matrix<double, terms, terms> moments = Eigen::Matrix<double, terms, terms>::Zero();
    Eigen::Matrix<double, D, terms> raw = Eigen::Matrix<double, D, terms>::Zero();
    for (const std::uint32_t j : rows_.row(i)) {
      const Vec x = apart(j, i);
      const Terms to = p(x), weighted = mass / density_[j] * kernel.F(x.norm()) * to;
      moments += weighted * to.transpose();
      raw += (body.velocity[j] - body.velocity[i]) * weighted.transpose();
    }
    fit_[i] = fit_of<D, terms>(moments);
    const Mat gradient = raw * fit_[i].transpose();
    compression_[i] = 1.0 - dt * gradient.trace();
    const Mat eps = 0.5 * (gradient + gradient.transpose()), half_turn = 0.25 * dt * (gradient - gradient.transpose());
    // The turn in the time step, as a rotation to the last bit (Hughes & Winget 1980, Int. J. Numer. Meth. Eng. 15,
    // 1862).
    const Mat turn = (Mat::Identity() - half_turn).inverse() * (Mat::Identity() + half_turn);
    deviator_[i] = turn * deviator_[i] * turn.transpose() +
                   2.0 * dt * body.moduli(i).shear * (eps - eps.trace() / 3.0 * Mat::Identity());
  }
}

// What every pair reads of a particle.
template <int D>
void HookeJaumann<D>::set_pull(const Body<D>& body, std::size_t i) {
  const double rho2 = density_[i] * density_[i];
  const Mat sigma = deviator_[i] - pressure(body, i) * Mat::Identity();
  pull_[i] = sigma * fit_[i];
  if (artificial_stress_ > 0.0) repulsion_[i] = against_tension<D>(sigma, artificial_stress_ / rho2);
}

template <int D>
template <class Kernel>
void HookeJaumann<D>::accelerate(Body<D>& body, const Kernel& kernel) const {
  const double mass = body.mass(), near = kernel.W(body.spacing), hs = 0.5 * reach_, c = body.wave_speed();
#pragma omp parallel for schedule(static) if (worth_threads(body.size()))
  for (std::size_t i = 0; i < body.size(); ++i) {
    Vec sum = Vec::Zero();
    for (const std::uint32_t j : rows_.row(i)) {
      const Vec x = apart(i, j), v = body.velocity[i] - body.velocity[j];
      const double r2 = x.squaredNorm(), r = std::sqrt(r2), along = v.dot(x), f = kernel.W(r) / near;
      const double mu = std::min(0.0, hs * along / (r2 + 0.01 * hs * hs));  // [m/s] of approach
      const double viscous = viscosity_ * c * mu / (0.5 * (density_[i] + density_[j]));
      const Vec elastic = (pull_[i] * p(-x) - pull_[j] * p(x)) / (density_[i] * density_[j]);
      const Vec artificial = (f * f) * (f * f) * ((repulsion_[i] + repulsion_[j]) * x) + viscous * x;
      sum += kernel.F(r) * (elastic - artificial);
    }
    body.force[i] = mass * mass * sum;
  }
}

template <int D>
void HookeJaumann<D>::find_forces(Body<D>& body, double dt) {
  follow(body);
  std::visit(
      [&](const auto& kernel) {
        strain(body, kernel, dt);
        bool sound = true;
        for (std::size_t i = 0; i < body.size(); ++i) {
          density_[i] *= compression_[i];
          sound = sound && std::abs(density_[i] / body.density - 1.0) < most_strain;
          set_pull(body, i);
        }
        if (!sound)
          throw base::RunError(
              fmt::format("the density of the solid {} has changed by half: it broke, or is driven harder than its "
                          "moduli can bear; use a smaller load or speed, a stiffer solid or another law",
                          body.name));
        accelerate(body, kernel);
      },
      kernel_);
}

template <int D>
double HookeJaumann<D>::step_limit(const Body<D>& body) const {
  return courant * 0.5 * reach_ / body.wave_speed();
}

template <int D>
double HookeJaumann<D>::energy(const Body<D>& body) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < body.size(); ++i) {
    const double p = pressure(body, i), across = D == 2 ? deviator_[i].trace() : 0.0;
    sum += p * p / (2.0 * body.bulk) + (deviator_[i].squaredNorm() + across * across) / (4.0 * body.moduli(i).shear);
  }
  return body.volume * sum;
}

template <int D>
Stress<D> HookeJaumann<D>::stress(const Body<D>& body, std::size_t particle) const {
  const double p = pressure(body, particle);
  return {deviator_[particle] - p * Mat::Identity(), -deviator_[particle].trace() - p};
}

template class HookeJaumann<2>;
template class HookeJaumann<3>;

}  // namespace shmoo::hydro
