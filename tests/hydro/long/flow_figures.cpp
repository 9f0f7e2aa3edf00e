// The flow's figures at full size, printed: Taylor-Green at 50^2 to t = 5, Poiseuille at 20 and 40 particles to t =
// 100, the temperature within 1 %, and the speed of a lid-driven cavity at 100^2.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <ctime>

#include "hydro/scenes.hpp"

namespace shmoo::hydro::testing {
namespace {

double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }  // of all threads

}  // namespace

TEST(Figures, TaylorGreen50) {
  auto fluid = make_fluid<2>(taylor_green_scene(50));
  fmt::print("Taylor-Green Re = 100, 50^2 from a lattice: t, amplitude error, energy error, smallest distance/dp\n");
  for (const double t : {1.0, 2.0, 5.0}) {
    fluid.advance(t);
    const double exact = std::exp(-8 * sph::pi * sph::pi * 0.01 * t);
    const double amplitude = fluid.max_speed() / exact - 1.0;
    const double energy = fluid.kinetic_energy() / (0.25 * exact * exact) - 1.0;
    fmt::print("  {:4.1f}  {:+.2f} %  {:+.2f} %  {:.3f}\n", t, 100 * amplitude, 100 * energy,
               fluid.smallest_distance());
    EXPECT_LT(std::abs(amplitude), 0.0075);
    EXPECT_LT(std::abs(energy), 0.02);
    EXPECT_GT(fluid.smallest_distance(), 0.7);
  }
}

class Poiseuille : public ::testing::TestWithParam<std::pair<int, double>> {};

TEST_P(Poiseuille, L2Error) {
  const auto [across, bound] = GetParam();
  auto fluid = make_fluid<2>(poiseuille_scene(across));
  const double start = cpu_seconds();
  fluid.advance(100.0);
  double sum = 0.0;
  const auto& flowing = fluid.state().rows.fluid();
  for (const auto i : flowing) {
    const double y = fluid.particles().position[i][1];
    sum += std::pow(fluid.velocity(i)[0] - 4 * y * (1 - y), 2);
  }
  const double error = std::sqrt(sum / double(flowing.size()));
  fmt::print("Poiseuille Ny = {}: L2 error {:.2e} at t = 100 (published {:.1e}), bounces {}, {:.1f} CPU s\n", across,
             error, bound, fluid.bounces(), cpu_seconds() - start);
  EXPECT_LT(error, bound);
}
INSTANTIATE_TEST_SUITE_P(Ny, Poiseuille, ::testing::Values(std::pair{20, 3.4e-2}, std::pair{40, 6.6e-3}));

// Mean over the run, with the standard error from blocks far longer than the friction time.
template <int D>
void temperature(int particles, int blocks, int steps) {
  auto scene = box_scene(D, 1.0, 1.0 / particles, 0.1);
  scene.effects.thermal_noise = true;
  scene.effects.transport_velocity = false;
  scene.flow.thermal_energy = 1e-4;
  auto fluid = make_fluid<D>(scene);
  for (int k = 0; k < 300; ++k) fluid.step();
  double mean = 0.0, squares = 0.0;
  const double start = cpu_seconds();
  for (int b = 0; b < blocks; ++b) {
    double block = 0.0;
    for (int k = 0; k < steps; ++k) {
      fluid.step();
      block += fluid.temperature() / 1e-4 / steps;
    }
    mean += block / blocks;
    squares += block * block / blocks;
  }
  const double speed = double(blocks) * steps * double(fluid.particles().size()) / (cpu_seconds() - start);
  const double error = std::sqrt((squares - mean * mean) / (blocks - 1));
  double scale = 0.0;
  for (const auto i : fluid.state().rows.fluid()) scale += fluid.velocity(i).norm();
  const double momentum = fluid.momentum().norm() / (fluid.scales().mass * scale);
  fmt::print(
      "thermal noise in {}-D at gamma dt = {:.2f}: kT/target {:.4f} +- {:.4f}, momentum {:.1e} of sum |m v|, {:.2e} "
      "particle-steps per CPU second\n",
      D, fluid.scales().friction * fluid.dt(), mean, error, momentum, speed);
  EXPECT_NEAR(mean, 1.0, 0.01);
  EXPECT_LT(momentum, 1e-12);
}

TEST(Figures, TemperatureIn2D) { temperature<2>(24, 20, 1000); }
TEST(Figures, TemperatureIn3D) { temperature<3>(8, 10, 300); }

TEST(Figures, CavitySpeed) {
  auto fluid = make_fluid<2>(cavity_scene(100, 100));
  fluid.advance(0.05);
  const double start = cpu_seconds();
  const auto before = fluid.steps();
  fluid.advance(0.25);
  const double elapsed = cpu_seconds() - start, steps = double(fluid.steps() - before);
  fmt::print(
      "lid-driven cavity 100^2, all on: {:.2e} fluid particle-steps per CPU second ({:.2e} with walls)\n",
      1e4 * steps / elapsed, double(fluid.particles().size()) * steps / elapsed);
  EXPECT_GT(1e4 * steps / elapsed, 1.2e6);
}

// Cavity at Re = 100 against Ghia, Ghia & Shin 1982, "High-Re solutions for incompressible flow using the Navier-Stokes
// equations and a multigrid method", Table I: u on the vertical centre line.
TEST(Figures, Cavity50) {
  constexpr double ghia[][2] = {{0.0547, -0.03717}, {0.0625, -0.04192}, {0.0703, -0.04775}, {0.1016, -0.06434},
                                {0.1719, -0.10150}, {0.2813, -0.15662}, {0.4531, -0.21090}, {0.5, -0.20581},
                                {0.6172, -0.13641}, {0.7344, 0.00332},  {0.8516, 0.23151},  {0.9531, 0.68717},
                                {0.9609, 0.73722},  {0.9688, 0.78871},  {0.9766, 0.84123}};
  auto fluid = make_fluid<2>(cavity_scene(50, 100));
  const double start = cpu_seconds();
  fluid.advance(15.0);
  double sum = 0.0;
  for (const auto& [y, u] : ghia) {
    // A least-squares plane through the velocities within two spacings.
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const auto i : fluid.state().rows.fluid()) {
      const base::Vec<2> d = fluid.particles().position[i] - base::Vec<2>(0.5, y);
      const double weight = std::max(0.0, 1.0 - d.norm() / 0.04);
      const Eigen::Vector3d basis(1.0, d[0], d[1]);
      normal += weight * basis * basis.transpose();
      right += weight * fluid.velocity(i)[0] * basis;
    }
    sum += std::pow(normal.inverse().row(0).dot(right) - u, 2);
  }
  const double error = std::sqrt(sum / std::size(ghia));
  double outside = 0;
  for (const auto i : fluid.state().rows.fluid()) {
    const auto& x = fluid.particles().position[i];
    outside += x.minCoeff() < 0.0 || x.maxCoeff() > 1.0;
  }
  fmt::print(
      "cavity Re = 100, 50^2, t = 15: RMS of u against Ghia {:.2e} (published method 3.0e-2), outside {}, bounces {}, "
      "{:.1f} CPU s\n",
      error, outside, fluid.bounces(), cpu_seconds() - start);
  EXPECT_LT(error, 0.03);
  EXPECT_EQ(outside, 0.0);
}

}  // namespace shmoo::hydro::testing
