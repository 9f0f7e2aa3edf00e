// What passes between a fluid and curved surfaces of held concentration: conduction through an annulus, 2 pi kappa dC/
// ln(b/a) exactly.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "memory_sink.hpp"

namespace {

using namespace shmoo;

const std::string annulus = R"toml(
title = "Conduction through an annulus"
[domain]
size = ["1 m", "1 m"]
spacing = "0.05 m"
material = "outer"
[materials.medium]
type = "still"
[materials.inner]
type = "still"
[materials.outer]
type = "still"
[[region]]
shape = "disk"
center = ["0.5 m", "0.5 m"]
radius = "0.45 m"
material = "medium"
[[region]]
shape = "disk"
center = ["0.5 m", "0.5 m"]
radius = "0.15 m"
material = "inner"
[species.T]
in = "medium"
diffusivity = "1 m^2/s"
method = "deterministic"
[[boundary]]
species = "T"
at = "inner"
type = "fixed"
value = "1e6 molecules/m^3"
[[boundary]]
species = "T"
at = "outer"
type = "fixed"
value = "0 molecules/m^3"
[[observable]]
name = "flux"
type = "species_flux"
species = "T"
in = "inner"
[[observable]]
name = "out"
type = "species_flux"
species = "T"
in = "outer"
[run]
until = "1 s"
record_every = "1 s"
)toml";

// Relative errors of the fluxes in and out once they are steady.
struct Errors {
  double in, out;
};
Errors errors(double exact, const scene::Overrides& overrides) {
  const test::Laboratory lab(scene::read_scene_text(annulus, "annulus.toml", overrides));
  return {lab.shared.observed("flux", 1)[0] / exact - 1.0, -lab.shared.observed("out", 1)[0] / exact - 1.0};
}

scene::Overrides spacing(int across) { return {{"domain.spacing", fmt::format("\"{} m\"", 1.0 / across)}}; }

scene::Overrides in_2d(int across, const std::string& jitter) {
  auto overrides = spacing(across);
  overrides.insert(overrides.end(), {{"dimension", "2"}, {"depth", "\"1 m\""}, {"domain.jitter", jitter}});
  return overrides;
}

const double of_cylinders = 2.0 * std::numbers::pi * 1e6 / std::log(3.0);

TEST(CurvedSurface, ConductsByTheLogarithmOfRadii) {
  for (const int across : {20, 40}) {
    const auto [in, out] = errors(of_cylinders, in_2d(across, "0"));
    EXPECT_NEAR(in, 0.0, 1e-3) << across;
    EXPECT_NEAR(out, in, 1e-4) << across;  // steady
  }
}

TEST(CurvedSurface, ConductsThroughDisorderToo) {
  for (const int across : {20, 40}) {
    EXPECT_NEAR(errors(of_cylinders, in_2d(across, "0.3")).in, 0.0, 0.01) << across;
  }
}

TEST(CurvedSurface, ConductsBetweenBallsByTheirRadii) {
  auto overrides = spacing(20);
  overrides.insert(overrides.end(), {{"dimension", "3"},
                                     {"domain.size", R"(["1 m", "1 m", "1 m"])"},
                                     {"region.0.shape", "\"ball\""},
                                     {"region.0.center", R"(["0.5 m", "0.5 m", "0.5 m"])"},
                                     {"region.1.shape", "\"ball\""},
                                     {"region.1.center", R"(["0.5 m", "0.5 m", "0.5 m"])"}});
  const double exact = 4.0 * std::numbers::pi * 1e6 / (1.0 / 0.15 - 1.0 / 0.45);
  EXPECT_NEAR(errors(exact, overrides).in, 0.0, 0.01);
}

// A slab from 0 to 1 between regions that are held and end there, a particle on either surface: C0 (1 - x) after 20 s.
TEST(PlaneSurface, EndsASlabWhereTheRegionEnds) {
  const auto lab = test::laboratory("validation/diffusion-1d/model.toml", {{"species.C.method", "\"deterministic\""},
                                                                           {"numerics.tolerance", "1e-9"},
                                                                           {"run.until", "\"20 s\""},
                                                                           {"run.record_every", "\"20 s\""},
                                                                           {"run.record_at", "[]"}});
  const auto& n = lab.shared.at("C", 1);
  ASSERT_EQ(n.size(), 17u);
  for (std::size_t i = 1; i < 16; ++i) EXPECT_NEAR(n[i] / 1e4, 1.0 - double(i) / 16.0, 1e-5) << i;
}

}  // namespace
