// Species that make the fluid lighter: the weight is what it says, follows the species, and is the same bits again.
#include <gtest/gtest.h>

#include <cmath>

#include "memory_sink.hpp"

namespace {

using namespace shmoo;

const std::string text = R"toml(
title = "Something light"
dimension = 2
depth = "1 m"
[domain]
size = ["1 m", "1 m"]
spacing = "0.05 m"
boundary = "periodic"
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.01 Pa s"
[parameters]
k = "6.283185307179586 1/m"
c = "1e5 molecules/m^3"
[flow]
gravity = ["0 m/s^2", "-2 m/s^2"]
reference_speed = "1 m/s"
[[buoyancy]]
species = "A"
expansion = "1e-6 m^3/molecule"
reference = "3e5 molecules/m^3"
[species.A]
diffusivity = "0.001 m^2/s"
method = "deterministic"
initial = "5e5 molecules/m^3"
[[observable]]
name = "v"
type = "velocity_profile"
axis = "x"
component = "y"
[run]
until = "0.5 s"
record_every = "0.5 s"
)toml";

std::vector<double> profile(const scene::Overrides& overrides) {
  const test::Laboratory lab(scene::read_scene_text(text, "light.toml", overrides));
  lab.realise(0);
  return lab.shared.observed("v", 1);
}

TEST(Buoyancy, AUniformSpeciesLiftsAllFluidAlike) {
  const double exact = 1e-6 * 2e5 * 2.0 * 0.5;  // b |g| t
  for (const double v : profile({})) ASSERT_NEAR(v / exact, 1.0, 1e-9);
  for (const double v : profile({{"species.A.initial", "\"3e5 molecules/m^3\""}})) ASSERT_NEAR(v, 0.0, 1e-12);
}

// Light columns rise beside heavy ones; viscosity and diffusion weaken the exact rise of 0.1 m/s by some per cent.
TEST(Buoyancy, FollowsTheSpecies) {
  const auto v = profile({{"species.A.initial", "{ expression = \"3*c + c*cos(k*x)\" }"}});
  const double k = 2.0 * std::acos(-1.0), kappa = 0.001, nu = 0.01;
  const double rise = 0.2 * (std::exp(-kappa * k * k * 0.5) - std::exp(-nu * k * k * 0.5)) / ((nu - kappa) * k * k);
  for (std::size_t b = 0; b < v.size(); ++b)
    ASSERT_NEAR(v[b], rise * std::cos(k * (double(b) + 0.5) / double(v.size())), 0.02 * rise);
  EXPECT_EQ(v, profile({{"species.A.initial", "{ expression = \"3*c + c*cos(k*x)\" }"}}));
}

}  // namespace
