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
constexpr double least_moment = 0.02;  // determinant of the second moment that is still inverted
constexpr double most_strain = 0.5;    // of the density that is still an elastic body's

// The part of the stress that pulls, turned to push.
template <int D>
base::Mat<D> against_tension(const base::Mat<D>& sigma, double strength) {
  const Eigen::SelfAdjointEigenSolver<base::Mat<D>> axes(sigma);
  const base::Vec<D> push = -strength * axes.eigenvalues().cwiseMax(0.0);
  return axes.eigenvectors() * push.asDiagonal() * axes.eigenvectors().transpose();
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
      correction_(body.size(), Mat::Identity()),
      pull_(body.size(), Mat::Zero()),
      repulsion_(body.size(), Mat::Zero()) {}

template <int D>
double HookeJaumann<D>::pressure(const Body<D>& body, std::size_t i) const {
  return body.bulk * (density_[i] / body.density - 1.0);
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
    Mat moment = Mat::Zero(), raw = Mat::Zero();
    for (const std::uint32_t j : rows_.row(i)) {
      const Vec x = apart(i, j);
      const Vec Fx = mass / density_[j] * kernel.F(x.norm()) * x;
      moment += Fx * x.transpose();
      raw += (body.velocity[i] - body.velocity[j]) * Fx.transpose();
    }
    correction_[i] = moment.determinant() > least_moment ? Mat(moment.inverse()) : Mat(Mat::Identity());
    const Mat gradient = raw * correction_[i];
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
  pull_[i] = sigma * correction_[i] / rho2;
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
      const Mat pair = pull_[i] + pull_[j] + (f * f) * (f * f) * (repulsion_[i] + repulsion_[j]);
      sum -= kernel.F(r) * (pair * x + viscous * x);
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
