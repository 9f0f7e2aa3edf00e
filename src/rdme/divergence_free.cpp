#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "rdme/jump_graph.hpp"

namespace shmoo::rdme {
namespace {

// Symmetric conductance of pair p out of voxel i; only pairs that carry something take part.
double conductance(const JumpGraph& graph, std::span<const double> volume, std::size_t i, std::uint64_t p) {
  return graph.flow[p] == 0.0 ? 0.0 : volume[i] * graph.coupling[p];
}

Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian(const JumpGraph& graph, std::span<const double> volume) {
  const std::size_t n = volume.size();
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(graph.target.size() + n);
  for (std::size_t i = 0; i < n; ++i) {
    double diagonal = 0.0;
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      const double a = conductance(graph, volume, i, p);
      if (a == 0.0) continue;
      entries.emplace_back(int(i), int(graph.target[p]), -a);
      diagonal += a;
    }
    entries.emplace_back(int(i), int(i), diagonal > 0.0 ? diagonal : 1.0);
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

double make_divergence_free(JumpGraph& graph, std::span<const double> volume) {
  if (graph.flow.empty()) return 0.0;
  const std::size_t n = volume.size();
  Eigen::VectorXd net = Eigen::VectorXd::Zero(int(n));
  double gross = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double out = 0.0;
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      net[int(i)] += graph.flow[p];
      out += std::abs(graph.flow[p]);
    }
    gross = std::max(gross, out);
  }
  if (gross == 0.0) return 0.0;
  const double before = net.cwiseAbs().maxCoeff() / gross;
  constexpr double aim = 1e-13;  // of the largest net flow, relative to the gross flow
  if (before < aim) return before;
  const auto matrix = laplacian(graph, volume);
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper> solver;
  solver.setTolerance(std::max(aim, 0.1 * aim * gross / net.norm()));
  solver.setMaxIterations(20000);
  solver.compute(matrix);
  const Eigen::VectorXd potential = solver.solve(-net);
  if (solver.info() != Eigen::Success && solver.error() * net.norm() > 1e-12 * gross) {
    throw base::RunError(
        "the carried flow could not be made divergence-free: conjugate gradients stopped at a residual of " +
        fmt::format("{:g} of the largest flow", solver.error() * net.norm() / gross));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      graph.flow[p] += conductance(graph, volume, i, p) * (potential[int(i)] - potential[int(graph.target[p])]);
    }
  }
  return before;
}

}  // namespace shmoo::rdme
