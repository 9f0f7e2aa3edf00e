#include "hydro/shell/equilibrium.hpp"

#include <cmath>
#include <numeric>

namespace shmoo::hydro {
namespace {

constexpr int most_iterations = 60, most_halvings = 30;
constexpr double first_shift = 1e-6, shift_growth = 10.0;  // of the largest diagonal entry
constexpr double roundoff = 1e-15;  // of the energy, relative to the bulk modulus times the volume
constexpr double fair = 1e-4;       // of the decrease that the slope promises (Armijo)

// Nothing holds the whole shell along the axis: its potential does not depend on that, and no force acts. So one
// coordinate stays where it is.
void pin(ShellEnergy::Matrix& tangent, int coordinate, double scale) {
  tangent.coeffRef(coordinate, coordinate) += 1e6 * scale;
}

void move(std::vector<Vec2>& x, const Eigen::VectorXd& step, double part) {
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += part * step.segment<2>(Eigen::Index(2 * i));
}

}  // namespace

// Returns the shift that was needed, relative to the largest diagonal entry.
double Equilibrium::factorise(const Shell& shell, double pressure) {
  ShellEnergy::Matrix matrix = energy_.tangent(shell, pressure);
  const double scale = matrix.diagonal().cwiseAbs().maxCoeff();
  pin(matrix, int(2 * shell.at(shell.columns - 1, 0)), scale);
  double before = 0.0;
  for (double shift = 0.0; shift < 1e3; shift = shift == 0.0 ? first_shift : shift * shift_growth) {
    matrix.diagonal().array() += (shift - before) * scale;
    before = shift;
    factors_.factorize(matrix);
    if (factors_.info() == Eigen::Success && factors_.vectorD().minCoeff() > 0.0) return shift;
  }
  return before;
}

bool Equilibrium::search(Shell& shell, double pressure, const Eigen::VectorXd& slope,
                         const Eigen::VectorXd& step) const {
  const double before = energy_.value(shell, pressure), promised = slope.dot(step);
  const double noise = roundoff * shell.bulk * std::accumulate(shell.V0.begin(), shell.V0.end(), 0.0);
  const auto start = shell.x;
  for (double part = 1.0; part > std::pow(0.5, most_halvings); part *= 0.5) {
    shell.x = start;
    move(shell.x, step, part);
    const double after = energy_.value(shell, pressure);
    if (after <= before + fair * part * promised) return true;
    if (after <= before + noise && energy_.gradient(shell, pressure).norm() < 0.5 * slope.norm()) return true;
  }
  shell.x = start;
  return false;
}

Balance Equilibrium::find(Shell& shell, double pressure, double tolerance) {
  Balance balance;
  for (;; ++balance.iterations) {
    const Eigen::VectorXd slope = energy_.gradient(shell, pressure);
    balance.residual = slope.cwiseAbs().maxCoeff();
    balance.converged = balance.residual <= tolerance;
    if (balance.converged || balance.iterations == most_iterations) return balance;
    balance.stable = factorise(shell, pressure) == 0.0;
    if (!search(shell, pressure, slope, -factors_.solve(slope))) return balance;
  }
}

}  // namespace shmoo::hydro
