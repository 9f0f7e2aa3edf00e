// A shell under pressure: Lame's solutions, the tangent, rezoning and growth.
#include "hydro/shell/rezone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "hydro/shell/equilibrium.hpp"
#include "hydro/shell/growth.hpp"

namespace shmoo::hydro::testing {
namespace {

constexpr double inner = 7.5e-6, outer = 10e-6;  // [m]
constexpr double nu = 0.3975;
const Moduli material = moduli(3.58e5, nu);

Shell shell_of(bool axial, int layers) {
  const double spacing = (outer - inner) / layers;
  const int columns = int(std::lround(std::numbers::pi * 0.5 * (inner + outer) / spacing));
  return make_shell({inner, outer, layers, columns}, axial, scene::ElasticLaw::neo_hookean, material);
}

double force_scale(bool axial, double pressure) { return pressure * outer * (axial ? outer : 1.0); }

Balance inflate(Shell& shell, Equilibrium& equilibrium, double pressure) {
  return equilibrium.find(shell, pressure, 1e-9 * force_scale(shell.axial, pressure));
}

// Timoshenko & Goodier 1970, "Theory of Elasticity", sections 28 and 136: radial displacement [m] and hoop stress [Pa].
std::pair<double, double> lame(bool axial, double p, double R) {
  const double E = 2.0 * material.shear * (1.0 + nu), n = axial ? 3.0 : 2.0;
  const double c = p * std::pow(inner, n) / (std::pow(outer, n) - std::pow(inner, n)), q = std::pow(outer / R, n);
  if (axial) return {c / E * R * ((1.0 - 2.0 * nu) + 0.5 * (1.0 + nu) * q), c * (1.0 + 0.5 * q)};
  return {(1.0 + nu) / E * c * R * ((1.0 - 2.0 * nu) + q), c * (1.0 + q)};
}

struct Errors {
  double displacement = 0, hoop = 0;  // relative, L2
};

Errors lame_errors(bool axial, int layers) {
  const double pressure = 100.0;
  Shell shell = shell_of(axial, layers);
  Equilibrium equilibrium(shell);
  EXPECT_TRUE(inflate(shell, equilibrium, pressure).converged);
  double volume = 0, moved = 0, du = 0, u2 = 0, dh = 0, h2 = 0;
  for (std::size_t i = 0; i < shell.size(); ++i)
    volume += shell.V0[i], moved += shell.V0[i] * (shell.x[i] - shell.X[i])[0];
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const Vec2 out = shell.X[i].normalized(), round(-out[1], out[0]);
    const auto [u, hoop] = lame(axial, pressure, shell.X[i].norm());
    const Vec2 off = shell.x[i] - shell.X[i] - Vec2(moved / volume, 0.0) - u * out;
    const auto at = equilibrium.energy().elastic(shell, i);
    const auto sigma = cauchy(ElasticPoint<2>(shell.law, {shell.shear[i], shell.bulk}, at).stress(), at);
    const double found = axial ? sigma.hoop : round.dot(sigma.P * round);
    du += shell.V0[i] * off.squaredNorm(), u2 += shell.V0[i] * u * u;
    dh += shell.V0[i] * std::pow(found - hoop, 2), h2 += shell.V0[i] * hoop * hoop;
  }
  return {std::sqrt(du / u2), std::sqrt(dh / h2)};
}

TEST(Shell, ThickRingUnderPressureIsLames) {
  const auto coarse = lame_errors(false, 6), fine = lame_errors(false, 12);
  EXPECT_LT(coarse.displacement, 0.01);
  EXPECT_LT(fine.displacement, 0.003);
  EXPECT_LT(coarse.hoop, 0.03);
  EXPECT_GT(std::log2(coarse.displacement / fine.displacement), 1.4);
}

TEST(Shell, ThickSphereUnderPressureIsLames) {
  const auto coarse = lame_errors(true, 6), fine = lame_errors(true, 10);
  EXPECT_LT(coarse.displacement, 0.01);
  EXPECT_LT(fine.displacement, 0.005);
  EXPECT_LT(coarse.hoop, 0.03);
  EXPECT_GT(std::log(coarse.displacement / fine.displacement) / std::log(10.0 / 6.0), 1.4);
}

// A shell bent out of all symmetry but the mirror's.
Shell bent(bool axial) {
  Shell shell = shell_of(axial, 4);
  for (std::size_t i = 0; i < shell.size(); ++i) {
    shell.x[i] *= 1.05 + 0.03 * std::sin(3.0 * double(i));
    shell.b[i] = 1.02;
    shell.B[i](0, 1) += 0.05;
    shell.shear[i] *= i % 3 ? 1.0 : 0.3;
  }
  return shell;
}

class Both : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Shells, Both, ::testing::Bool());

TEST_P(Both, GradientAndTangentAreDerivativesOfTheEnergy) {
  Shell shell = bent(GetParam());
  ShellEnergy energy(shell);
  const double pressure = 2e4, h = 1e-11;
  const Eigen::VectorXd slope = energy.gradient(shell, pressure);
  const Eigen::MatrixXd lower = energy.tangent(shell, pressure);
  const Eigen::MatrixXd tangent = lower.selfadjointView<Eigen::Lower>();
  for (const Eigen::Index dof : {0L, 1L, 7L, 100L, slope.size() - 1}) {
    double& x = shell.x[std::size_t(dof / 2)][dof % 2];
    const double at = x;
    x = at + h;
    const double up = energy.value(shell, pressure);
    const Eigen::VectorXd above = energy.gradient(shell, pressure);
    x = at - h;
    const double down = energy.value(shell, pressure);
    const Eigen::VectorXd column = (above - energy.gradient(shell, pressure)) / (2.0 * h);
    x = at;
    EXPECT_NEAR((up - down) / (2.0 * h), slope[dof], 1e-5 * slope.cwiseAbs().maxCoeff());
    EXPECT_LT((column - tangent.col(dof)).norm(), 1e-7 * tangent.col(dof).norm());
  }
}

TEST_P(Both, LeftAndRightStayAlike) {
  Shell shell = shell_of(GetParam(), 6);
  Equilibrium equilibrium(shell);
  ASSERT_TRUE(inflate(shell, equilibrium, 3e4).converged);
  const auto outline = equilibrium.energy().outer_surface(shell);
  const double middle = 0.5 * (outline.front()[0] + outline.back()[0]);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const auto& other = outline[outline.size() - 1 - k];
    EXPECT_NEAR(outline[k][0] - middle, middle - other[0], 1e-14);  // 1e-8 um
    EXPECT_NEAR(outline[k][1], other[1], 1e-14);
  }
}

TEST_P(Both, RezoningKeepsWhatIsThereAndNearlyTheEquilibrium) {
  Shell shell = shell_of(GetParam(), 6);
  Equilibrium equilibrium(shell);
  for (std::size_t i = 0; i < shell.size(); ++i)  // the tip bulges
    shell.shear[i] *= 1.0 - 0.7 * std::exp(-std::pow(shell.X[i][1] / 4e-6, 2)) * double(shell.X[i][0] > 0.0);
  ASSERT_TRUE(inflate(shell, equilibrium, 3e4).converged);
  const auto before = equilibrium.energy().outer_surface(shell);
  const double V0 = std::accumulate(shell.V0.begin(), shell.V0.end(), 0.0);
  std::vector<double> moved(shell.size(), 0.0);
  for (const auto& take : rezone(shell, equilibrium.energy())) moved[take.to] += take.share;
  EXPECT_NEAR(std::accumulate(shell.V0.begin(), shell.V0.end(), 0.0), V0, 1e-13 * V0);
  EXPECT_NEAR(std::accumulate(moved.begin(), moved.end(), 0.0), double(shell.size()), 1e-9);
  equilibrium.energy().refer(shell);
  ASSERT_TRUE(inflate(shell, equilibrium, 3e4).converged);
  const auto after = equilibrium.energy().outer_surface(shell);
  EXPECT_NEAR(after.front()[0] - after.back()[0], before.front()[0] - before.back()[0], 0.01e-6);
}

// A shell that grows alike everywhere under a pressure that it hardly notices: its radius obeys dR/dt = gamma R.
TEST(Shell, GrowthIsStableBeyondTheExplicitStep) {
  const double pressure = 1e3, coefficient = 1e-6, dt = 50.0;  // explicit steps: 2/(phi C M) = 2.2 s at most
  Shell shell = shell_of(true, 4);
  Equilibrium equilibrium(shell);
  ASSERT_TRUE(inflate(shell, equilibrium, pressure).converged);
  const std::vector<double> concentration(shell.size(), 1.0);
  double last = 0.0;
  for (int step = 0; step < 20; ++step) {
    grow(shell, equilibrium.energy(), {0, coefficient, 0.0}, concentration, dt);
    ASSERT_TRUE(inflate(shell, equilibrium, pressure).converged) << step;
    const double radius = shell.x[shell.at(0, 0)].norm();
    EXPECT_GE(radius, last);
    last = radius;
    for (const double rate : shell.growth) EXPECT_LT(rate * dt, 0.1);
  }
}

TEST(Shell, PressureBeyondTheLimitLoadHasNoEquilibrium) {
  const double limit = material.shear * std::log(outer / inner);  // of a ring of an incompressible neo-Hookean
  Shell held = shell_of(false, 6);
  Equilibrium equilibrium(held);
  Shell lost = held;
  for (int part = 1; part <= 6; ++part) ASSERT_TRUE(inflate(held, equilibrium, 0.6 * limit * part / 6).converged);
  EXPECT_FALSE(inflate(lost, equilibrium, 1.3 * limit).converged);
}

}  // namespace
}  // namespace shmoo::hydro::testing
