// Gradients that balance a stress which is the same everywhere.
#include "hydro/shell/balanced_gradients.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hydro/shell/enclosed.hpp"
#include "hydro/shell/equilibrium.hpp"
#include "hydro/shell/hoop.hpp"

namespace shmoo::hydro::testing {
namespace {

constexpr double inner = 7.5e-6, outer = 10e-6;  // [m]
constexpr double nu = 0.3975;
const Moduli material = moduli(3.58e5, nu);

Shell shell_of(bool axial, int layers) {
  const int columns = int(std::lround(layers * std::numbers::pi * 2.0 * (inner + outer) / (outer - inner) / 2.0));
  return make_shell({inner, outer, layers, columns}, axial, scene::ElasticLaw::neo_hookean, material);
}

std::vector<Row> balanced(const Shell& shell) {
  auto rows = make_stencil(shell);
  std::vector<Eigen::MatrixXd> forms;
  for (std::size_t i = 0; i < shell.size(); ++i) forms.push_back(unseen(shell, rows[i], i));
  balance_gradients(shell, forms, rows);
  return rows;
}

// What a stress of 1 everywhere does to the particles: the volumes' strains, less what presses on the surfaces.
Eigen::Matrix2Xd unbalanced(const Shell& shell, const std::vector<Row>& rows) {
  Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, Eigen::Index(shell.size()));
  const auto add = [&](const Neighbour& one, const Vec2& f) {
    force.col(Eigen::Index(one.particle)) += Vec2(f[0], one.mirror * f[1]);
  };
  for (std::size_t i = 0; i < shell.size(); ++i) {
    for (const auto& one : rows[i]) add(one, shell.V0[i] * one.gradient);
    if (shell.axial) force(1, Eigen::Index(i)) += shell.V0[i] / shell.X[i][1];
  }
  const auto plain = make_stencil(shell);
  for (const int sign : {-1, 1}) {
    const auto outline = sign > 0 ? outline_rows(shell, plain, 0, shell.inside)
                                  : outline_rows(shell, plain, shell.layers - 1, shell.outside);
    const auto places = points(outline, shell.X);
    for (std::size_t k = 0; k + 1 < places.size(); ++k) {
      const Edge pressed = sign * edge_gradient(shell.axial, edge_at(places, k));
      for (const auto& one : outline[k]) add(one, one.weight * pressed.head<2>());
      for (const auto& one : outline[k + 1]) add(one, one.weight * pressed.tail<2>());
    }
  }
  return force;
}

double largest(const Eigen::Matrix2Xd& force) { return force.cwiseAbs().maxCoeff(); }

class BalancedGradient : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Shells, BalancedGradient, ::testing::Bool());

// But for what the surfaces' points enclose less than the particles fill, a part in the square of the columns' number.
TEST_P(BalancedGradient, LeaveNoForceWhereTheStressIsTheSame) {
  const Shell shell = shell_of(GetParam(), 6);
  const double scale = largest(unbalanced(shell, make_stencil(shell)));
  EXPECT_LT(largest(unbalanced(shell, balanced(shell))), 1e-3 * scale);
}

TEST_P(BalancedGradient, AreExactForLinearDisplacements) {
  const Shell shell = shell_of(GetParam(), 4);
  const Mat2 A = (Mat2() << 1.1, 0.0, 0.0, 0.8).finished();  // alike on both sides of the axis
  std::vector<Vec2> x;
  for (const auto& X : shell.X) x.push_back(A * X);
  for (const auto& row : balanced(shell)) EXPECT_LT((deformation_gradient(row, x) - A).norm(), 1e-10);
}

// By every particle alike, those next to the axis with the others (Timoshenko & Goodier 1970, section 136).
double strain_error(int layers) {
  const double pressure = 100.0, E = 2.0 * material.shear * (1.0 + nu);
  const double c = pressure / (std::pow(outer / inner, 3) - 1.0);
  Shell shell = shell_of(true, layers);
  Equilibrium equilibrium(shell);
  EXPECT_TRUE(equilibrium.find(shell, pressure, 1e-9 * pressure * outer * outer).converged);
  double sum = 0.0;
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const double q = std::pow(outer / shell.X[i].norm(), 3);
    const double exact = c / E * ((1.0 - 2.0 * nu) + 0.5 * (1.0 + nu) * q);
    sum += std::pow(hoop_at(shell, equilibrium.energy(), i).strain / exact - 1.0, 2);
  }
  return std::sqrt(sum / double(shell.size()));
}

TEST(BalancedGradients, SwellASphereRightUpToItsAxis) {
  const double coarse = strain_error(6), fine = strain_error(10);
  EXPECT_LT(coarse, 0.025);
  EXPECT_LT(fine, 0.01);
  EXPECT_GT(std::log(coarse / fine) / std::log(10.0 / 6.0), 1.4);
}

}  // namespace
}  // namespace shmoo::hydro::testing
