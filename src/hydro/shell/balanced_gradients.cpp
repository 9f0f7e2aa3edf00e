#include "hydro/shell/balanced_gradients.hpp"

#include <Eigen/SparseCholesky>
#include <algorithm>

#include "hydro/shell/enclosed.hpp"

namespace shmoo::hydro {
namespace {

constexpr double firm = 1e-9;  // of the largest entry: holds what no form sees

using Eigen::Index;
using Forces = Eigen::Matrix2Xd;

// [m^3] of the reference, which growth leaves alone: it makes V0 larger by as much as B and b smaller.
double volume(const Shell& shell, std::size_t i) { return shell.V0[i] * shell.B[i].determinant() * shell.b[i]; }

void add_volume_gradient(const Shell& shell, const std::vector<Row>& outline, double sign, Forces& sum) {
  const auto places = points(outline, shell.X);
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    const Edge gradient = edge_gradient(shell.axial, edge_at(places, k));
    for (std::size_t end = 0; end < 2; ++end) {
      const Vec2 at = sign * gradient.segment<2>(Index(2 * end));
      for (const auto& one : outline[k + end])
        sum.col(Index(one.particle)) += one.weight * Vec2(at[0], one.mirror * at[1]);
    }
  }
}

// By particle [m^2], plane: [m].
Forces missing(const Shell& shell, const std::vector<Row>& rows) {
  Forces sum = Forces::Zero(2, Index(shell.size()));
  add_volume_gradient(shell, outline_rows(shell, rows, shell.layers - 1, shell.outside), 1.0, sum);
  add_volume_gradient(shell, outline_rows(shell, rows, 0, shell.inside), -1.0, sum);
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const double V = volume(shell, i);
    if (shell.axial) sum(1, Index(i)) -= V / shell.X[i][1];
    for (const auto& one : rows[i])
      sum.col(Index(one.particle)) -= V * Vec2(one.gradient[0], one.mirror * one.gradient[1]);
  }
  return sum;
}

void take_out(Eigen::VectorXd& from, const Eigen::VectorXd& part) {
  from -= from.dot(part) / part.squaredNorm() * part;
}

// Along one axis, without what no change of gradients can bring: constants, and the places themselves. Points enclose
// a little less than particles fill.
Eigen::VectorXd reachable(const Shell& shell, const Forces& forces, int axis) {
  Eigen::VectorXd all = forces.row(axis), places(all.size());
  for (Index i = 0; i < places.size(); ++i) places[i] = shell.X[std::size_t(i)][axis];
  if (axis == 0) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(all.size());
    take_out(all, ones);
    take_out(places, ones);
  }
  take_out(all, places);
  return all;
}

// What an image has of its particle's vector along an axis.
double sign(const Neighbour& one, int axis) { return axis == 0 ? 1.0 : one.mirror; }

// sum_i V_i^2 N_i for fields along one axis; lower triangle.
Eigen::SparseMatrix<double> matrix(const Shell& shell, const std::vector<Eigen::MatrixXd>& forms,
                                   const std::vector<Row>& rows, int axis) {
  std::vector<Eigen::Triplet<double>> entries;
  double largest = 0.0;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const double V = volume(shell, i);
    for (std::size_t a = 0; a < rows[i].size(); ++a) {
      for (std::size_t b = 0; b < rows[i].size(); ++b) {
        const auto &one = rows[i][a], &two = rows[i][b];
        if (one.particle < two.particle) continue;
        const double entry = V * V * sign(one, axis) * sign(two, axis) * forms[i](Index(a), Index(b));
        entries.emplace_back(int(one.particle), int(two.particle), entry);
        largest = std::max(largest, entry);
      }
    }
  }
  for (int i = 0; i < int(shell.size()); ++i) entries.emplace_back(i, i, firm * largest);
  Eigen::SparseMatrix<double> sum(Index(shell.size()), Index(shell.size()));
  sum.setFromTriplets(entries.begin(), entries.end());
  return sum;
}

}  // namespace

Eigen::MatrixXd unseen(const Shell& shell, const Row& row, std::size_t i) {
  const auto n = Index(row.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
  for (Index j = 1; j < n; ++j) {
    const Vec2 apart = row[std::size_t(j)].place(shell.X) - shell.X[i];
    Eigen::VectorXd off(n);  // of the difference x_ij - F_i X_ij
    for (Index k = 0; k < n; ++k) off[k] = -row[std::size_t(k)].gradient.dot(apart);
    off[j] += 1.0;
    off[0] -= 1.0;
    sum += row[std::size_t(j)].weight / apart.squaredNorm() * off * off.transpose();
  }
  return sum;
}

void balance_gradients(const Shell& shell, const std::vector<Eigen::MatrixXd>& forms, std::vector<Row>& rows) {
  const Forces wanted = missing(shell, rows);
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::NaturalOrdering<int>> factors(
        matrix(shell, forms, rows, axis));
    const Eigen::VectorXd mu = factors.solve(reachable(shell, wanted, axis));
    for (std::size_t i = 0; i < shell.size(); ++i) {
      Eigen::VectorXd near(Index(rows[i].size()));
      for (std::size_t a = 0; a < rows[i].size(); ++a)
        near[Index(a)] = sign(rows[i][a], axis) * mu[Index(rows[i][a].particle)];
      const Eigen::VectorXd change = volume(shell, i) * (forms[i] * near);
      for (std::size_t a = 0; a < rows[i].size(); ++a) rows[i][a].gradient[axis] += change[Index(a)];
    }
  }
}

}  // namespace shmoo::hydro
