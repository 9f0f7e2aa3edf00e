#include "rdme/linear_exact.hpp"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// -sum_j a_ij d_ij along the free axes, and the largest of them relative to sum_j a_ij |d_ij|.
template <int D>
std::pair<Eigen::VectorXd, double> residual(const PairWeights<D>& pairs) {
  const std::size_t n = pairs.free.size();
  Eigen::VectorXd right = Eigen::VectorXd::Zero(Eigen::Index(n * D));
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    base::Vec<D> sum = base::Vec<D>::Zero();
    double gross = 0.0;
    for (std::uint64_t p = pairs.first[i]; p < pairs.first[i + 1]; ++p) {
      sum += pairs.weight[p] * pairs.step[p];
      gross += pairs.weight[p] * pairs.step[p].norm();
    }
    for (int a = 0; a < D; ++a) {
      if (!pairs.free[i][std::size_t(a)]) continue;
      right[Eigen::Index(i * D + std::size_t(a))] = -sum[a];
      largest = std::max(largest, std::abs(sum[a]) / gross);
    }
  }
  return {right, largest};
}

template <int D>
Matrix normal_matrix(const PairWeights<D>& pairs) {
  const std::size_t n = pairs.free.size();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(D * D * (pairs.target.size() + n));
  for (std::size_t i = 0; i < n; ++i) {
    base::Mat<D> diagonal = base::Mat<D>::Zero();
    for (std::uint64_t p = pairs.first[i]; p < pairs.first[i + 1]; ++p) {
      const base::Mat<D> block = pairs.weight[p] * pairs.step[p] * pairs.step[p].transpose();
      diagonal += block;
      const std::size_t j = pairs.target[p];
      for (int a = 0; a < D; ++a)
        for (int b = 0; b < D; ++b) {
          if (!pairs.free[i][std::size_t(a)] || !pairs.free[j][std::size_t(b)]) continue;
          entries.emplace_back(int(i * D) + a, int(j * D) + b, -block(a, b));
        }
    }
    for (int a = 0; a < D; ++a) {
      const bool free_a = pairs.free[i][std::size_t(a)];
      if (!free_a) entries.emplace_back(int(i * D) + a, int(i * D) + a, 1.0);
      for (int b = 0; b < D; ++b) {
        if (free_a && pairs.free[i][std::size_t(b)])
          entries.emplace_back(int(i * D) + a, int(i * D) + b, diagonal(a, b));
      }
    }
  }
  Matrix matrix(Eigen::Index(n * D), Eigen::Index(n * D));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

template <int D>
std::vector<double> linear_exact_factors(const PairWeights<D>& pairs) {
  std::vector<double> factor(pairs.target.size(), 1.0);
  const auto [right, largest] = residual(pairs);
  if (largest < 1e-9) return factor;
  Eigen::ConjugateGradient<Matrix, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(1e-10);
  solver.setMaxIterations(10000);
  const Matrix matrix = normal_matrix(pairs);
  solver.compute(matrix);
  const Eigen::VectorXd mu = solver.solve(right);
  if (solver.info() != Eigen::Success && !(solver.error() < 1e-6)) {
    throw base::RunError(
        "pair weights could not be made exact for linear profiles: conjugate gradients stopped at a residual of " +
        std::to_string(solver.error()));
  }
  for (std::size_t i = 0; i < pairs.free.size(); ++i) {
    for (std::uint64_t p = pairs.first[i]; p < pairs.first[i + 1]; ++p) {
      const auto difference =
          mu.segment<D>(Eigen::Index(i * D)) - mu.segment<D>(Eigen::Index(std::size_t(pairs.target[p]) * D));
      factor[p] = std::clamp(1.0 + difference.dot(pairs.step[p]), 0.05, 20.0);
    }
  }
  return factor;
}

template std::vector<double> linear_exact_factors(const PairWeights<1>&);
template std::vector<double> linear_exact_factors(const PairWeights<2>&);
template std::vector<double> linear_exact_factors(const PairWeights<3>&);

}  // namespace shmoo::rdme
