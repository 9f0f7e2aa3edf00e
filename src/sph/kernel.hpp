#pragma once
// Smoothing kernels with compact support. W is normalised in D dimensions, W(r) = 0 for r >= reach; F = -W'(r)/r >= 0,
// so that grad_i W_ij = -F_ij x_ij (x_ij = x_i - x_j). Dividing by r is done in closed form where F is finite at r = 0.
// Distances are numbers or vectors of numbers; no branch depends on them.
#include <cmath>
#include <numbers>
#include <variant>

#include "scene/scene.hpp"

#if defined(__AVX512F__)
#include <immintrin.h>
#endif

namespace shmoo::sph {

inline constexpr double pi = std::numbers::pi;

template <class Number>
Number positive(const Number& s) {
#if defined(__AVX512F__)
  if constexpr (sizeof(Number) == sizeof(__m512d)) return Number(_mm512_max_pd(__m512d(s), __m512d{}));
#endif
  return s > 0.0 ? s : Number{};
}

// Lucy 1977, "A numerical approach to the testing of the fission hypothesis", with the normalisation of D dimensions.
template <int D>
struct Lucy {
  explicit Lucy(double reach) : reach_(reach), inverse_(1.0 / reach) {
    const double c = D == 1 ? 5.0 / 4.0 : D == 2 ? 5.0 / pi : 105.0 / (16.0 * pi);
    w_ = c * std::pow(inverse_, D);
    f_ = 12.0 * w_ * inverse_ * inverse_;
  }
  double reach() const { return reach_; }  // [m]
  template <class Number>
  Number W(const Number& r) const {  // [1/m^D]
    const Number q = r * inverse_, s = positive(Number(1.0 - q));
    return w_ * (1.0 + 3.0 * q) * s * s * s;
  }
  template <class Number>
  Number F(const Number& r) const {  // [1/m^(D+2)]
    const Number s = positive(Number(1.0 - r * inverse_));
    return f_ * s * s;
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
  template <class Number>
  Number W(const Number& r) const {
    const Number q = r * inverse_, s = positive(Number(1.0 - q)), s2 = s * s;
    return w_ * s2 * s2 * (1.0 + 4.0 * q);
  }
  template <class Number>
  Number F(const Number& r) const {
    const Number s = positive(Number(1.0 - r * inverse_));
    return f_ * s * s * s;
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
  template <class Number>
  Number W(const Number& r) const {
    const Number u = r * inverse_, t = positive(Number(2.0 - u));
    const Number inner = w_ * (1.0 + u * u * (0.75 * u - 1.5)), outer = w_ * 0.25 * t * t * t;
    return u < 1.0 ? inner : outer;
  }
  template <class Number>
  Number F(const Number& r) const {
    const Number u = r * inverse_, t = positive(Number(2.0 - u));
    const Number inner = f_ * (3.0 - 2.25 * u), outer = f_ * 0.75 * t * t / u;
    return u < 1.0 ? inner : outer;
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
  template <class Number>
  Number W(const Number& r) const {
    const Number u = r * inverse_;
    const Number a = positive(Number(3.0 - u)), b = positive(Number(2.0 - u)), c = positive(Number(1.0 - u));
    return w_ * (fourth(a) * a - 6.0 * fourth(b) * b + 15.0 * fourth(c) * c);
  }
  template <class Number>
  Number F(const Number& r) const {
    const Number u = r * inverse_, a = positive(Number(3.0 - u)), b = positive(Number(2.0 - u));
    const Number inner = f_ * (120.0 + u * u * (50.0 * u - 120.0));
    const Number outer = f_ * 5.0 * (fourth(a) - 6.0 * fourth(b)) / u;
    return u < 1.0 ? inner : outer;
  }

 private:
  template <class Number>
  static Number fourth(const Number& s) {
    return (s * s) * (s * s);
  }
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
