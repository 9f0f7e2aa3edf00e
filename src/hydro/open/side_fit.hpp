#pragma once
// Kernel-weighted least squares about a point of an open side, over the fluid inside. A fit about a particle beyond the
// side would be singular where that sees one row of fluid only.
#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "base/vec.hpp"

namespace shmoo::hydro {

// Values that are known on the side and vary linearly across it: their slope, likewise by least squares.
class SlopeFit {
 public:
  void add(double weight, double distance, double above) {
    square_ += weight * distance * distance;
    product_ += weight * distance * above;
  }
  double at(double distance) const { return square_ > 0.0 ? distance * product_ / square_ : 0.0; }

 private:
  double square_ = 0, product_ = 0;
};

// N values that vary linearly along and across the side, or, where not across, quadratically along it: so a parabola
// between walls is continued as it is.
template <int D, int N, bool Across>
class SideFit {
 public:
  static constexpr int terms = Across ? D + 1 : D * (D + 1) / 2;
  using Values = Eigen::Matrix<double, N, 1>;

  explicit SideFit(int axis) : axis_(axis) {}

  // r from the point, in reaches.
  void add(double weight, const base::Vec<D>& r, const Values& value) {
    const Basis basis = basis_at(r);
    normal_ += weight * basis * basis.transpose();
    right_ += weight * basis * value.transpose();
  }

  bool empty() const { return !(normal_(0, 0) > 0.0); }

  // The value `distance` reaches along the axis from the point; of too little fluid the mean.
  Values at(double distance) const {
    const Eigen::LDLT<Matrix> solver(normal_ / normal_(0, 0));
    if (!(solver.rcond() > least_condition)) return right_.row(0).transpose() / normal_(0, 0);
    base::Vec<D> r = base::Vec<D>::Zero();
    r[axis_] = distance;
    return (solver.solve(right_).transpose() * basis_at(r)) / normal_(0, 0);
  }

 private:
  static constexpr double least_condition = 1e-4;
  using Basis = Eigen::Matrix<double, terms, 1>;
  using Matrix = Eigen::Matrix<double, terms, terms>;

  Basis basis_at(const base::Vec<D>& r) const {
    Basis basis;
    basis[0] = 1.0;
    int next = 1;
    for (int a = 0; a < D; ++a)
      if (a != axis_) basis[next++] = r[a];
    if constexpr (Across) {
      basis[next] = r[axis_];
    } else {
      for (int a = 1; a < D; ++a)
        for (int b = a; b < D; ++b) basis[next++] = basis[a] * basis[b];
    }
    return basis;
  }

  int axis_;
  Matrix normal_ = Matrix::Zero();
  Eigen::Matrix<double, terms, N> right_ = Eigen::Matrix<double, terms, N>::Zero();
};

}  // namespace shmoo::hydro
