#pragma once
// Static equilibrium of a shell: the positions at which its potential is least. Newton's method with the exact tangent,
// sparse LDL^T factors, the tangent shifted until it is positive, and a line search.
#include <Eigen/SparseCholesky>

#include "hydro/shell/energy.hpp"

namespace shmoo::hydro {

struct Balance {
  double residual = 0;  // [N], plane: [N/m]: the largest force on a particle that is left
  int iterations = 0;
  bool stable = true;  // the tangent is positive there: a minimum
  bool converged = false;
};

class Equilibrium {
 public:
  explicit Equilibrium(const Shell& shell) : energy_(shell) { factors_.analyzePattern(energy_.tangent(shell, 0.0)); }

  ShellEnergy& energy() { return energy_; }

  // Moves the shell's particles from where they are to rest under `pressure` [Pa], so that no force is larger than
  // `tolerance` [N], plane: [N/m].
  Balance find(Shell& shell, double pressure, double tolerance);

 private:
  double factorise(const Shell& shell, double pressure);
  bool search(Shell& shell, double pressure, const Eigen::VectorXd& slope, const Eigen::VectorXd& step) const;

  ShellEnergy energy_;
  Eigen::SimplicialLDLT<ShellEnergy::Matrix, Eigen::Lower, Eigen::NaturalOrdering<int>> factors_;
};

}  // namespace shmoo::hydro
