// Species under the transport velocity: a uniform concentration stays uniform, amounts are conserved, a steady flow
// carries what it should, and the mean of the molecules is the deterministic amount.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ensemble_moments.hpp"
#include "memory_sink.hpp"

namespace {

using namespace shmoo;

const std::string vortices = R"toml(
title = "Species in Taylor-Green vortices"
dimension = 2
depth = "1 m"
[domain]
size = ["1 m", "1 m"]
spacing = "0.05 m"
boundary = { x = "periodic", y = "periodic" }
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.01 Pa s"
[parameters]
k = "6.283185307179586 1/m"
speed = "1 m/s"
c = "40000 molecules/m^3"
[flow]
initial_velocity = ["-speed * cos(k*x) * sin(k*y)", "speed * sin(k*x) * cos(k*y)"]
[species.U]
diffusivity = "0.001 m^2/s"
method = "deterministic"
initial = "1000 molecules/m^3"
[species.S]
diffusivity = "0.001 m^2/s"
method = "stochastic"
initial = { expression = "c * (1 + cos(k*x))" }
[species.D]
diffusivity = "0.001 m^2/s"
method = "deterministic"
initial = { expression = "c * (1 + cos(k*x))" }
[run]
until = "0.3 s"
record_every = "0.1 s"
)toml";

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

// The largest relative deviation from uniformity at the end, and the largest change of a voxel's capacity.
std::pair<double, double> nonuniformity(const std::string& step) {
  const test::Laboratory lab(scene::read_scene_text(
      vortices, "vortices.toml", {{"numerics.splitting_step", step}, {"numerics.tolerance", "1e-10"}}));
  const auto sink = lab.realise(0);
  const auto& volume = lab.shared.at("volume", 3);
  const auto& amount = sink.at("U", 3);
  double deviation = 0.0, changed = 0.0;
  for (std::size_t i = 0; i < amount.size(); ++i) {
    deviation = std::max(deviation, std::abs(amount[i] / volume[i] / 1000.0 - 1.0));
    changed = std::max(changed, std::abs(volume[i] / 0.0025 - 1.0));
  }
  return {deviation, changed};
}

// Capacities change within an interval while rates stand: an error of second order in the interval.
TEST(CarriedSpecies, AUniformConcentrationStaysUniformInAMovingFluid) {
  const auto [coarse, changed] = nonuniformity("\"0.01 s\"");
  const double fine = nonuniformity("\"0.005 s\"").first;
  EXPECT_GT(changed, 1e-4);  // volume did pass between particles, though what passes is made to cancel
  EXPECT_LT(coarse, 3e-5);
  EXPECT_LT(fine, coarse / 3.0);
}

TEST(CarriedSpecies, AmountsAndMoleculesAreConserved) {
  const test::Laboratory lab(scene::read_scene_text(vortices, "vortices.toml", {}));
  coupling::Outcome outcome;
  const auto sink = lab.realise(0, &outcome);
  EXPECT_TRUE(outcome.balanced);
  EXPECT_NEAR(sum(sink.at("U", 3)), 1000.0, 1e-8);
  EXPECT_EQ(sum(sink.at("S", 0)), sum(sink.at("S", 3)));
  EXPECT_NEAR(sum(sink.at("D", 0)), sum(sink.at("D", 3)), 1e-6);
}

TEST(CarriedSpecies, TheMeanOfTheMoleculesIsTheDeterministicAmount) {
  const test::Laboratory lab(scene::read_scene_text(vortices, "vortices.toml", {}));
  test::Moments moments;
  const int realisations = 40;
  for (int k = 0; k < realisations; ++k) moments.add(lab.realise(std::uint32_t(k)).at("S", 3));
  const auto mean = lab.realise(0).at("D", 3);
  double chi2 = 0.0;
  std::size_t degrees = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    if (mean[i] < 1.0) continue;
    chi2 += std::pow(moments.mean(i) - mean[i], 2) / (mean[i] / realisations);  // multinomial: variance below the mean
    ++degrees;
  }
  // Normal approximation of chi-square with 400 degrees: five standard deviations, false alarms below 1e-6.
  EXPECT_LT(chi2, double(degrees) + 5.0 * std::sqrt(2.0 * double(degrees)));
  EXPECT_GT(chi2, 0.3 * double(degrees));
}

const std::string convection = R"toml(
title = "What a hot cylinder lifts in a cold room"
dimension = 2
depth = "1 m"
[domain]
size = ["1 m", "1 m"]
spacing = "0.04 m"
boundary = "wall"
[materials.fluid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "8.3666e-3 Pa s"
[materials.cylinder]
type = "wall"
[[region]]
shape = "disk"
center = ["0.5 m", "0.5 m"]
diameter = "0.2 m"
material = "cylinder"
[species.T]
in = "fluid"
diffusivity = "1.195229e-2 m^2/s"
method = "deterministic"
[[boundary]]
species = "T"
at = "cylinder"
type = "fixed"
value = "1e6 molecules/m^3"
[[buoyancy]]
species = "T"
expansion = "1e-6 m^3/molecule"
[flow]
gravity = ["0 m/s^2", "-1 m/s^2"]
reference_speed = "0.5 m/s"
[run]
until = "5 s"
record_every = "5 s"
)toml";

// Jump rates go by capacities, so these must stay near what the particles fill, also where the transport velocity
// goes on taking from voxels beside a curved wall.
TEST(CarriedSpecies, CapacitiesStayNearWhatParticlesFillBesideACurvedWall) {
  const test::Laboratory lab(scene::read_scene_text(convection, "convection.toml", {}));
  const auto& volume = lab.shared.at("volume", 1);
  double total = 0.0;
  for (const double v : volume) {
    EXPECT_NEAR(v / 0.0016, 1.0, 0.08);
    total += v / 0.0016;
  }
  EXPECT_NEAR(total, double(volume.size()), 1e-9 * total);
}

const std::string channel = R"toml(
title = "A blob carried along a slow channel"
dimension = 2
depth = "1 m"
[domain]
size = ["2 m", "1 m"]
spacing = "0.1 m"
boundary = { x = "periodic", y = "wall" }
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "1 Pa s"
[parameters]
from = "0.5 m"
to = "1 m"
c = "1000 molecules/m^3"
[flow]
body_force = ["0.8 m/s^2", "0 m/s^2"]
[species.U]
diffusivity = "0.02 m^2/s"
method = "deterministic"
initial = "1000 molecules/m^3"
[species.B]
diffusivity = "0.02 m^2/s"
method = "deterministic"
initial = { expression = "(x > from) * (x < to) * c" }
[numerics]
steady_tolerance = 1e-2
[run]
until = "4 s"
record_every = "2 s"
)toml";

TEST(CarriedSpecies, ASteadyFlowCarriesAndLeavesAUniformConcentrationAlone) {
  const test::Laboratory lab(scene::read_scene_text(channel, "channel.toml", {}));
  const auto derived = lab.experiment->derived();
  const auto steady =
      std::find_if(derived.begin(), derived.end(), [](const auto& d) { return d.name == "flow steady since"; });
  ASSERT_NE(steady, derived.end());
  EXPECT_LT(steady->value, 2.0);
  const auto& amount = lab.shared.at("U", 2);
  const auto& volume = lab.shared.at("volume", 2);
  for (std::size_t i = 0; i < amount.size(); ++i) EXPECT_NEAR(amount[i] / volume[i], 1000.0, 1e-2);
  // The blob's phase along the period moves with the mean velocity it sees; the parabola's mean is 2/3 of 0.1 m/s.
  const auto phase = [&](std::size_t time) {
    double c = 0.0, s = 0.0;
    const auto& n = lab.shared.at("B", time);
    const auto& x = lab.shared.at("position", time);
    for (std::size_t i = 0; i < n.size(); ++i) {
      c += n[i] * std::cos(M_PI * x[2 * i]);
      s += n[i] * std::sin(M_PI * x[2 * i]);
    }
    return std::atan2(s, c) / M_PI;
  };
  double moved = phase(2) - phase(1);
  if (moved < 0.0) moved += 2.0;  // the period
  EXPECT_NEAR(moved, 2.0 * 0.1 * 2.0 / 3.0, 0.02);
}

}  // namespace
