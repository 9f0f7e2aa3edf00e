#include "hydro/shell/energy.hpp"

#include <limits>

#include "hydro/shell/balanced_gradients.hpp"
#include "hydro/shell/enclosed.hpp"

namespace shmoo::hydro {
namespace {

constexpr double alpha = 1.0;  // of the hourglass term

std::vector<int> coordinates(const Row& row) {
  std::vector<int> all;
  for (const auto& one : row) all.insert(all.end(), {int(2 * one.particle), int(2 * one.particle + 1)});
  return all;
}

// The strains' derivatives by the row's coordinates: [strains x 2 row].
Eigen::MatrixXd strain_operator(const Shell& shell, const Row& row, std::size_t i) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(strains<2>, Eigen::Index(2 * row.size()));
  for (std::size_t a = 0; a < row.size(); ++a) {
    const Vec2 q = shell.B[i].transpose() * row[a].gradient;
    for (int c = 0; c < 2; ++c) {
      M(2 * c, Eigen::Index(2 * a)) = q[c];
      M(1 + 2 * c, Eigen::Index(2 * a + 1)) = row[a].mirror * q[c];
    }
  }
  if (shell.axial) M(4, 1) = shell.b[i] / shell.X[i][1];
  return M;
}

Eigen::MatrixXd edge_operator(const Row& first, const Row& second) {
  Eigen::MatrixXd M = Eigen::MatrixXd::Zero(4, Eigen::Index(2 * (first.size() + second.size())));
  Eigen::Index a = 0;
  for (const Row* row : {&first, &second}) {
    const int point = row == &first ? 0 : 2;
    for (const auto& one : *row) {
      M(point, 2 * a) = one.weight;
      M(point + 1, 2 * a + 1) = one.weight * one.mirror;
      ++a;
    }
  }
  return M;
}

// Of a row's particles; the hourglass term does not see what is linear, so that it may act on these.
Eigen::MatrixXd displacements(const Shell& shell, const Row& row) {
  Eigen::MatrixXd all(Eigen::Index(row.size()), 2);
  for (std::size_t a = 0; a < row.size(); ++a)
    all.row(Eigen::Index(a)) = (row[a].place(shell.x) - row[a].place(shell.X)).transpose();
  return all;
}

}  // namespace

ShellEnergy::ShellEnergy(const Shell& shell) {
  refer(shell);
  for (const auto& row : rows_) particles_.push_back({coordinates(row), {}});
  for (std::size_t k = 0; k + 1 < outline_.size(); ++k) {
    edges_.push_back({coordinates(outline_[k]), {}});
    const auto second = coordinates(outline_[k + 1]);
    edges_.back().coordinate.insert(edges_.back().coordinate.end(), second.begin(), second.end());
  }
  lay_out(2 * shell.size());
}

void ShellEnergy::refer(const Shell& shell) {
  rows_ = make_stencil(shell);
  hourglass_.clear();
  for (std::size_t i = 0; i < shell.size(); ++i) hourglass_.push_back(unseen(shell, rows_[i], i));
  outline_ = outline_rows(shell, rows_, 0, shell.inside);
  balance_gradients(shell, hourglass_, rows_);
  for (std::size_t i = 0; i < shell.size(); ++i) hourglass_[i] *= alpha * shell.V0[i];
}

void ShellEnergy::lay_out(std::size_t unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (auto* group : {&particles_, &edges_}) {
    for (const auto& element : *group) {
      for (const int c : element.coordinate) {
        for (const int r : element.coordinate) {
          if (r >= c) entries.emplace_back(r, c, 0.0);
        }
      }
    }
  }
  tangent_.resize(Eigen::Index(unknowns), Eigen::Index(unknowns));
  tangent_.setFromTriplets(entries.begin(), entries.end());
  for (auto* group : {&particles_, &edges_}) {
    for (auto& element : *group) {
      for (const int c : element.coordinate) {
        for (const int r : element.coordinate)
          element.slot.push_back(r >= c ? int(&tangent_.coeffRef(r, c) - tangent_.valuePtr()) : -1);
      }
    }
  }
}

Deformation<2> ShellEnergy::elastic(const Shell& shell, std::size_t i) const {
  const double hoop = shell.axial ? shell.x[i][1] / shell.X[i][1] : 1.0;
  return {deformation_gradient(rows_[i], shell.x) * shell.B[i], hoop * shell.b[i]};
}

std::vector<Vec2> ShellEnergy::cavity(const Shell& shell) const { return points(outline_, shell.x); }

std::vector<Vec2> ShellEnergy::outer_surface(const Shell& shell) const {
  std::vector<Vec2> outline;
  for (int k = 0; k < shell.columns; ++k) {
    const std::size_t i = shell.at(k, shell.layers - 1);
    outline.push_back(shell.x[i] + deformation_gradient(rows_[i], shell.x) * shell.outside[std::size_t(k)]);
  }
  return outline;
}

double ShellEnergy::cavity_volume(const Shell& shell) const {
  const auto outline = cavity(shell);
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) sum += edge_volume(shell.axial, edge_at(outline, k));
  return sum;
}

double ShellEnergy::value(const Shell& shell, double pressure) const {
  double sum = -pressure * cavity_volume(shell);
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const auto at = elastic(shell, i);
    if (!(at.J() > 0.0) || !(at.hoop > 0.0)) return std::numeric_limits<double>::infinity();
    sum += shell.V0[i] * ElasticPoint<2>(shell.law, {shell.shear[i], shell.bulk}, at).energy();
    const Eigen::MatrixXd u = displacements(shell, rows_[i]);
    sum += 0.5 * shell.shear[i] * (u.transpose() * (hourglass_[i] * u)).trace();
  }
  return sum;
}

Eigen::VectorXd ShellEnergy::gradient(const Shell& shell, double pressure) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(Eigen::Index(2 * shell.size()));
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const auto stress = ElasticPoint<2>(shell.law, {shell.shear[i], shell.bulk}, elastic(shell, i)).stress();
    const Mat2 T = shell.V0[i] * stress.P * shell.B[i].transpose();
    const Eigen::MatrixXd hold = shell.shear[i] * hourglass_[i] * displacements(shell, rows_[i]);
    for (std::size_t a = 0; a < rows_[i].size(); ++a) {
      const auto& one = rows_[i][a];
      const Vec2 force = T * one.gradient + hold.row(Eigen::Index(a)).transpose();
      all[Eigen::Index(2 * one.particle)] += force[0];
      all[Eigen::Index(2 * one.particle + 1)] += one.mirror * force[1];
    }
    if (shell.axial) all[Eigen::Index(2 * i + 1)] += shell.V0[i] * stress.hoop * shell.b[i] / shell.X[i][1];
  }
  const auto outline = cavity(shell);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Eigen::VectorXd part = edge_operator(outline_[k], outline_[k + 1]).transpose() *
                                 (-pressure * edge_gradient(shell.axial, edge_at(outline, k)));
    for (std::size_t a = 0; a < edges_[k].coordinate.size(); ++a) all[edges_[k].coordinate[a]] += part[Eigen::Index(a)];
  }
  return all;
}

Eigen::MatrixXd ShellEnergy::particle_tangent(const Shell& shell, std::size_t i) const {
  const ElasticPoint<2> point(shell.law, {shell.shear[i], shell.bulk}, elastic(shell, i));
  const Eigen::MatrixXd M = strain_operator(shell, rows_[i], i);
  Eigen::MatrixXd local = M.transpose() * (shell.V0[i] * point.tangent() * M);
  for (std::size_t b = 0; b < rows_[i].size(); ++b) {
    for (std::size_t a = 0; a < rows_[i].size(); ++a) {
      const double hold = shell.shear[i] * hourglass_[i](Eigen::Index(a), Eigen::Index(b));
      local(Eigen::Index(2 * a), Eigen::Index(2 * b)) += hold;
      local(Eigen::Index(2 * a + 1), Eigen::Index(2 * b + 1)) += rows_[i][a].mirror * rows_[i][b].mirror * hold;
    }
  }
  return local;
}

void ShellEnergy::add(const Element& element, const Eigen::MatrixXd& local) {
  for (std::size_t s = 0; s < element.slot.size(); ++s) {
    if (element.slot[s] >= 0) tangent_.valuePtr()[element.slot[s]] += local.data()[s];
  }
}

const ShellEnergy::Matrix& ShellEnergy::tangent(const Shell& shell, double pressure) {
  tangent_.coeffs().setZero();
  for (std::size_t i = 0; i < shell.size(); ++i) add(particles_[i], particle_tangent(shell, i));
  const auto outline = cavity(shell);
  for (std::size_t k = 0; k < edges_.size(); ++k) {
    const Eigen::MatrixXd M = edge_operator(outline_[k], outline_[k + 1]);
    add(edges_[k], M.transpose() * (-pressure * edge_hessian(shell.axial, edge_at(outline, k))) * M);
  }
  return tangent_;
}

}  // namespace shmoo::hydro
