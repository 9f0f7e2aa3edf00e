// What elastic bodies in motion owe to mechanics: momentum, angular momentum, energy, rotation, the same bits.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Geometry>
#include <numbers>

#include "base/error.hpp"
#include "hydro/solid/solids.hpp"
#include "hydro/solid/total_lagrangian.hpp"
#include "scene/read.hpp"

namespace shmoo::hydro::testing {
namespace {

// A bar in the middle of a box; `more` goes to its material.
std::string bar(int dimension, const std::string& more, const std::string& thickness = "0.4 m") {
  const bool deep = dimension == 3;
  const auto point = [&](const char* x, const std::string& y) {
    return fmt::format("[\"{}\", \"{}\"{}]", x, y, deep ? ", \"" + y + "\"" : "");
  };
  const char* top = thickness == "0.4 m" ? "0.2 m" : "-0.1 m";
  return fmt::format(
      "dimension = {}\n{}[domain]\nsize = {}\norigin = {}\nspacing = \"0.1 m\"\n[materials.bar]\ntype = \"solid\"\n"
      "density = \"1000 kg/m^3\"\nshear_modulus = \"1e5 Pa\"\npoisson_ratio = 0.3\n{}\n[[region]]\nmaterial = \"bar\"\n"
      "shape = \"box\"\nlower = {}\nupper = {}\n[run]\nuntil = \"1 s\"\n",
      dimension, deep ? "" : "depth = \"1 m\"\n", point("4 m", "4 m"), point("-2 m", "-2 m"), more,
      point("-0.6 m", "-0.2 m"), point("0.6 m", top));
}

template <int D>
Solids<D> solids_of(const std::string& text) {
  const auto scene = scene::read_scene_text(text, "bar.toml");
  return Solids<D>(scene, sph::fill<D>(scene));
}

template <int D>
base::Vec<3> angular_momentum(const Body<D>& body) {
  base::Vec<3> sum = base::Vec<3>::Zero();
  for (std::size_t i = 0; i < body.size(); ++i) {
    base::Vec<3> x = base::Vec<3>::Zero(), v = x;
    x.head<D>() = body.start[i] + body.displacement[i];
    v.head<D>() = body.velocity[i];
    sum += body.mass() * x.cross(v);
  }
  return sum;
}

template <int D>
void advance(Solids<D>& solids, int steps) {
  double t = 0.0;
  for (int k = 0; k < steps; ++k) {
    const double dt = solids.step_limit();
    solids.advance(t, dt);
    t += dt;
  }
}

template <int D>
void check_conservation(const std::string& law) {
  auto solids = solids_of<D>(bar(D, "law = \"" + law + "\""));
  auto& body = solids.bodies()[0];
  for (std::size_t i = 0; i < body.size(); ++i) {
    for (int a = 0; a < D; ++a) body.velocity[i][a] = 2.0 * std::sin(3.0 * body.start[i][(a + 1) % D] + a) + 0.3;
  }
  const auto momentum = solids.momentum();
  const auto turning = angular_momentum(body);
  const double energy = solids.kinetic_energy() + solids.elastic_energy();
  advance(solids, 2000);
  EXPECT_LT((solids.momentum() - momentum).norm(), 1e-11 * momentum.norm());
  EXPECT_LT((angular_momentum(body) - turning).norm(), 1e-11 * turning.norm());
  EXPECT_NEAR((solids.kinetic_energy() + solids.elastic_energy()) / energy, 1.0, 0.01);
  EXPECT_GT(solids.elastic_energy(), 0.01 * energy);
}

TEST(SolidMotion, ConservesMomentumAngularMomentumAndEnergy) {
  for (const char* law : {"neo-hookean", "saint-venant-kirchhoff"}) {
    check_conservation<2>(law);
    check_conservation<3>(law);
  }
}

// Energy of a bar set swinging hard has no trend over fifty periods of its slowest wave.
TEST(SolidMotion, EnergyDoesNotDriftInFiftyPeriods) {
  auto solids =
      solids_of<2>(bar(2,
                       "fixed = { shape = \"box\", lower = [\"-0.6 m\", \"-1 m\"], upper = [\"-0.4 m\", \"1 m\"] }\n"
                       "initial_velocity = [\"0 m/s\", \"3 m/s\"]"));
  const double energy = solids.kinetic_energy() + solids.elastic_energy();
  double t = 0.0, largest = 0.0, last = 0.0;
  int swings = 0;
  const auto& body = solids.bodies()[0];
  while (swings < 50) {
    const double dt = solids.step_limit();
    solids.advance(t, dt);
    t += dt;
    const double end = body.displacement.back()[1];
    swings += last < 0.0 && end >= 0.0;
    last = end;
    largest = std::max(largest, std::abs((solids.kinetic_energy() + solids.elastic_energy()) / energy - 1.0));
    ASSERT_LT(t, 100.0);
  }
  EXPECT_LT(largest, 0.01);
}

template <int D>
void check_rotation(const base::Mat<D>& R) {
  auto solids = solids_of<D>(bar(D, ""));
  auto& body = solids.bodies()[0];
  TotalLagrangian<D> law(body, base::Box<D>{});
  for (std::size_t i = 0; i < body.size(); ++i) body.displacement[i] = R * body.start[i] - body.start[i];
  law.find_forces(body, 0.0);
  for (std::size_t i = 0; i < body.size(); ++i) {
    EXPECT_LT(law.stress(body, i).P.norm(), 1e-10 * body.shear);
    EXPECT_LT(body.force[i].norm(), 1e-10 * body.shear * std::pow(body.spacing, D - 1));
  }
}

TEST(SolidMotion, RigidRotationLeavesNoStress) {
  for (int degrees = 0; degrees <= 360; degrees += 24) {
    const double angle = degrees * std::numbers::pi / 180.0;
    check_rotation<2>(Eigen::Rotation2Dd(angle).toRotationMatrix());
    check_rotation<3>(Eigen::AngleAxisd(angle, Eigen::Vector3d(1, -2, 0.4).normalized()).toRotationMatrix());
  }
}

// A body that turns freely through several turns keeps its shape but for what its spin stretches.
TEST(SolidMotion, TurnsManyTimesWithoutStiffening) {
  auto solids = solids_of<2>(bar(2, "initial_velocity = [\"-w*y\", \"w*x\"]\n[parameters]\nw = \"2 1/s\"\n"));
  auto& body = solids.bodies()[0];
  const double energy = solids.kinetic_energy();
  const auto turning = angular_momentum(body);
  double t = 0.0;
  while (t < 4.0 * std::numbers::pi) {  // four turns
    const double dt = solids.step_limit();
    solids.advance(t, dt);
    t += dt;
  }
  EXPECT_LT((angular_momentum(body) - turning).norm(), 1e-11 * turning.norm());
  EXPECT_NEAR(solids.kinetic_energy() / energy, 1.0, 0.02);
  const Eigen::Vector2d along =
      body.start.back() + body.displacement.back() - body.start.front() - body.displacement.front();
  EXPECT_NEAR(along.norm() / (body.start.back() - body.start.front()).norm(), 1.0, 0.01);
}

TEST(SolidMotion, HeldPartsMoveAsTheyAreTold) {
  auto solids =
      solids_of<2>(bar(2,
                       "fixed = { shape = \"box\", lower = [\"-0.6 m\", \"-1 m\"], upper = [\"-0.3 m\", \"1 m\"] }\n"
                       "angular_velocity = \"3 1/s\"\ncenter = [\"0 m\", \"0 m\"]"));
  double t = 0.0;
  while (t < 0.5) {
    const double dt = std::min(solids.step_limit(), 0.5 - t);
    solids.advance(t, dt);
    t = dt < solids.step_limit() ? 0.5 : t + dt;
  }
  const auto& body = solids.bodies()[0];
  const Eigen::Rotation2Dd turned(1.5);
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Eigen::Vector2d off = body.start[i] + body.displacement[i] - turned * body.start[i];
    EXPECT_TRUE(!body.held[i] || off.norm() < 1e-9);
  }
  EXPECT_GT(solids.kinetic_energy(), 0.0);
}

// The law in rates, too, takes a turn for no strain, and swings at the elastic law's pace.
TEST(SolidMotion, JaumannsRateTurnsStressAlong) {
  auto solids =
      solids_of<2>(bar(2,
                       "law = \"hooke-jaumann\"\nartificial_viscosity = 0\n"
                       "fixed = { shape = \"box\", lower = [\"-1 m\", \"-1 m\"], upper = [\"1 m\", \"1 m\"] }\n"
                       "angular_velocity = \"6.283185307179586 1/s\"\ncenter = [\"0 m\", \"0 m\"]"));
  solids.advance(0.0, 0.25);
  const auto& body = solids.bodies()[0];
  const Eigen::Vector2d start = body.start[0], end = start + body.displacement[0];
  EXPECT_LT((end - Eigen::Vector2d(-start[1], start[0])).norm(), 1e-9);
  for (std::size_t i = 0; i < body.size(); ++i) EXPECT_LT(body.force[i].norm(), 1e-3 * body.shear * body.spacing);
}

TEST(SolidMotion, BothFormsSwingAlike) {
  const auto swing = [](const std::string& law) {
    auto text = bar(2, "law = \"" + law +
                           "\"\nfixed = { shape = \"box\", lower = [\"-0.6 m\", \"-1 m\"], upper = "
                           "[\"-0.4 m\", \"1 m\"] }\ninitial_velocity = [\"0 m/s\", \"0.1 m/s\"]");
    text.replace(text.find("spacing = \"0.1 m"), 16, "spacing = \"0.04 m");
    auto solids = solids_of<2>(text);
    const auto& body = solids.bodies()[0];
    double t = 0.0, before = 0.0;
    while (t < 10.0) {
      const double dt = solids.step_limit();
      solids.advance(t, dt);
      t += dt;
      const double now = body.displacement.back()[1];
      if (before > 0.0 && now <= 0.0) return t;
      before = now;
    }
    return t;
  };
  EXPECT_NEAR(swing("hooke-jaumann") / swing("neo-hookean"), 1.0, 0.15);
}

TEST(SolidMotion, SameBitsForAnyNumberOfThreads) {
  auto text =
      bar(3, "initial_velocity = [\"3 m/s\", \"-w*z\", \"w*y*y/L\"]\n[parameters]\nw = \"2 1/s\"\nL = \"1 m\"\n");
  text.replace(text.find("spacing = \"0.1 m"), 16, "spacing = \"0.03 m");
  const auto run = [&](int threads) {
    omp_set_num_threads(threads);
    auto solids = solids_of<3>(text);
    EXPECT_GT(solids.bodies()[0].size(), 4 * 1500u) << "too few particles for threads";
    advance(solids, 5);
    omp_set_num_threads(1);
    return solids.bodies()[0].displacement;
  };
  EXPECT_EQ(run(1), run(5));
}

TEST(SolidMotion, RefusesAThinSheetAndReportsAnInvertedBody) {
  EXPECT_THROW(solids_of<2>(bar(2, "", "0.1 m")), base::InputError);
  auto solids = solids_of<2>(bar(2, "initial_velocity = [\"-w*x\", \"0 m/s\"]\n[parameters]\nw = \"2000 1/s\"\n"));
  EXPECT_THROW(advance(solids, 1000), base::RunError);
}

}  // namespace
// A velocity that is no number ends the run, even where all others are sound.
TEST(SolidMotion, WhatIsNoNumberIsRefused) {
  auto solids = solids_of<2>(bar(2, "law = \"hooke-jaumann\""));
  solids.bodies()[0].velocity[7][1] = std::numeric_limits<double>::quiet_NaN();
  try {
    advance(solids, 2);
    ADD_FAILURE() << "went on";
  } catch (const base::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("is no number any more"), std::string::npos) << error.what();
  }
}

}  // namespace shmoo::hydro::testing
