#pragma once
// Smoothing kernels with compact support. W is normalised in D dimensions, W(r) = 0 for r >= reach; F = -W'(r)/r >= 0,
// so that grad_i W_ij = -F_ij x_ij (x_ij = x_i - x_j). Dividing by r is done in closed form where F is finite at r = 0.
#include <cmath>
#include <numbers>
#include <variant>

#include "scene/scene.hpp"

namespace shmoo::sph {

inline constexpr double pi = std::numbers::pi;

// Lucy 1977, "A numerical approach to the testing of the fission hypothesis", with the normalisation of D dimensions.
template <int D>
struct Lucy {
  explicit Lucy(double reach) : reach_(reach), inverse_(1.0 / reach) {
    const double c = D == 1 ? 5.0 / 4.0 : D == 2 ? 5.0 / pi : 105.0 / (16.0 * pi);
    w_ = c * std::pow(inverse_, D);
    f_ = 12.0 * w_ * inverse_ * inverse_;
  }
  double reach() const { return reach_; }  // [m]
  double W(double r) const {               // [1/m^D]
    const double q = r * inverse_, s = 1.0 - q;
    return q < 1.0 ? w_ * (1.0 + 3.0 * q) * s * s * s : 0.0;
  }
  double F(double r) const {  // [1/m^(D+2)]
    const double q = r * inverse_, s = 1.0 - q;
    return q < 1.0 ? f_ * s * s : 0.0;
  }

 private:
  double reach_, inverse_, w_, f_;
};

// Wendland 1995, "Piecewise polynomial, positive definite and compactly supported radial functions", C2; in 1-D it is
// Lucy's.
template <int D>
struct WendlandC2 {
  explicit WendlandC2(double reach) : reach_(reach), inverse_(1.0 / reach) {
    const double c = D == 2 ? 7.0 / pi : 21.0 / (2.0 * pi);
    w_ = c * std::pow(inverse_, D);
    f_ = 20.0 * w_ * inverse_ * inverse_;
  }
  double reach() const { return reach_; }
  double W(double r) const {
    const double q = r * inverse_, s = 1.0 - q, s2 = s * s;
    return q < 1.0 ? w_ * s2 * s2 * (1.0 + 4.0 * q) : 0.0;
  }
  double F(double r) const {
    const double q = r * inverse_, s = 1.0 - q;
    return q < 1.0 ? f_ * s * s * s : 0.0;
  }

 private:
  double reach_, inverse_, w_, f_;
};

template <>
struct WendlandC2<1> : Lucy<1> {
  using Lucy<1>::Lucy;
};

// Cubic B-spline (Monaghan & Lattanzio 1985, "A refined particle method for astrophysical problems"); knots at reach/2.
template <int D>
struct CubicSpline {
  explicit CubicSpline(double reach) : reach_(reach), inverse_(2.0 / reach) {
    const double c = D == 1 ? 2.0 / 3.0 : D == 2 ? 10.0 / (7.0 * pi) : 1.0 / pi;
    w_ = c * std::pow(inverse_, D);
    f_ = w_ * inverse_ * inverse_;
  }
  double reach() const { return reach_; }
  double W(double r) const {
    const double u = r * inverse_, t = 2.0 - u;
    if (u < 1.0) return w_ * (1.0 + u * u * (0.75 * u - 1.5));
    return u < 2.0 ? w_ * 0.25 * t * t * t : 0.0;
  }
  double F(double r) const {
    const double u = r * inverse_, t = 2.0 - u;
    if (u < 1.0) return f_ * (3.0 - 2.25 * u);
    return u < 2.0 ? f_ * 0.75 * t * t / u : 0.0;
  }

 private:
  double reach_, inverse_, w_, f_;
};

// Quintic B-spline (Morris, Fox & Zhu 1997, "Modeling low Reynolds number incompressible flows using SPH"); knots at
// reach/3 and 2 reach/3.
template <int D>
struct QuinticSpline {
  explicit QuinticSpline(double reach) : reach_(reach), inverse_(3.0 / reach) {
    const double c = D == 1 ? 1.0 / 120.0 : D == 2 ? 7.0 / (478.0 * pi) : 1.0 / (120.0 * pi);
    w_ = c * std::pow(inverse_, D);
    f_ = w_ * inverse_ * inverse_;
  }
  double reach() const { return reach_; }
  double W(double r) const {
    const double u = r * inverse_;
    return w_ * (fifth(3.0 - u) - 6.0 * fifth(2.0 - u) + 15.0 * fifth(1.0 - u));
  }
  double F(double r) const {
    const double u = r * inverse_;
    if (u < 1.0) return f_ * (120.0 + u * u * (50.0 * u - 120.0));
    return u < 3.0 ? f_ * 5.0 * (fourth(3.0 - u) - 6.0 * fourth(2.0 - u)) / u : 0.0;
  }

 private:
  static double fourth(double s) { return s > 0.0 ? (s * s) * (s * s) : 0.0; }
  static double fifth(double s) { return s > 0.0 ? (s * s) * (s * s) * s : 0.0; }
  double reach_, inverse_, w_, f_;
};

template <int D>
using AnyKernel = std::variant<Lucy<D>, CubicSpline<D>, QuinticSpline<D>, WendlandC2<D>>;

// `reach` is the radius of the support [m].
template <int D>
AnyKernel<D> make_kernel(scene::Kernel kind, double reach) {
  switch (kind) {
    case scene::Kernel::lucy:
      return Lucy<D>(reach);
    case scene::Kernel::cubic_spline:
      return CubicSpline<D>(reach);
    case scene::Kernel::quintic_spline:
      return QuinticSpline<D>(reach);
    case scene::Kernel::wendland_c2:
      break;
  }
  return WendlandC2<D>(reach);
}

}  // namespace shmoo::sph
