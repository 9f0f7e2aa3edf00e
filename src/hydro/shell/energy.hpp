#pragma once
// The potential of a shell under the pressure p of its cavity, its gradient and its tangent:
//   Pi = sum_i V0_i psi(Fe_i) + alpha sum_i G_i/2 V0_i sum_j w_ij |x_ij - F_i X_ij|^2/|X_ij|^2 - p Vol.
// Fe = F B, hoop stretch b y/Y in axial shells. The second term resists what F does not see (hourglass modes;
// Ganzenmueller 2015, Comput. Methods Appl. Mech. Eng. 286, 87), w the kernel's weights. Vol is enclosed by surface
// points s_k = x_k + F_k (S_k - X_k), half a spacing inside the innermost particles.
#include <Eigen/SparseCore>

#include "hydro/shell/stencil.hpp"

namespace shmoo::hydro {

class ShellEnergy {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  explicit ShellEnergy(const Shell& shell);

  // The shell has a new reference, of as many columns and layers.
  void refer(const Shell& shell);

  // [J], plane: [J/m]; infinite where a particle is turned inside out.
  double value(const Shell& shell, double pressure) const;
  // Coordinate 2 i + axis of particle i. [N], plane: [N/m].
  Eigen::VectorXd gradient(const Shell& shell, double pressure) const;
  const Matrix& tangent(const Shell& shell, double pressure);  // lower triangle

  Deformation<2> elastic(const Shell& shell, std::size_t i) const;
  std::vector<Vec2> cavity(const Shell& shell) const;  // its outline from tip to back
  std::vector<Vec2> outer_surface(const Shell& shell) const;
  double cavity_volume(const Shell& shell) const;  // [m^3], plane: [m^2]
  const std::vector<Row>& rows() const { return rows_; }

 private:
  // A part of the energy that depends on few coordinates, and where in the tangent each pair of them stands.
  struct Element {
    std::vector<int> coordinate;
    std::vector<int> slot;  // [a + n b]; -1: in the upper triangle
  };
  void lay_out(std::size_t unknowns);
  Eigen::MatrixXd particle_tangent(const Shell& shell, std::size_t i) const;
  void add(const Element& element, const Eigen::MatrixXd& local);

  std::vector<Row> rows_;
  std::vector<Eigen::MatrixXd> hourglass_;  // by particle, of its row, per G_i
  std::vector<Row> outline_;                // by column: s_k = sum_j weight_kj x_j
  std::vector<Element> particles_, edges_;
  Matrix tangent_;
};

}  // namespace shmoo::hydro
