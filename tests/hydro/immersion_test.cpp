// What elastic solids in a fluid owe to mechanics: equal and opposite impulses, and nothing where there are none.
#include <gtest/gtest.h>
#include <omp.h>

#include "base/error.hpp"
#include "hydro/fluid.hpp"
#include "hydro/scenes.hpp"
#include "scene/read.hpp"

namespace shmoo::hydro::testing {
namespace {

// A disk in the middle of a periodic box of fluid.
std::string disk(const std::string& density, const std::string& more, const std::string& numerics = "") {
  return R"toml(dimension = 2
depth = "1 m"
[domain]
size = ["1 m", "1 m"]
spacing = "0.05 m"
boundary = { x = "periodic", y = "periodic" }
material = "liquid"
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.02 Pa s"
[materials.disk]
type = "solid"
poisson_ratio = 0.4
shear_modulus = "100 Pa"
density = ")toml" +
         density + "\"\n" + more + R"toml(
[[region]]
material = "disk"
shape = "disk"
center = ["0.5 m", "0.5 m"]
radius = "0.2 m"
[parameters]
U = "1 m/s"
k = "6.283185307179586 1/m"
[flow]
initial_velocity = ["-U * cos(k*x) * sin(k*y)", "U * sin(k*x) * cos(k*y)"]
[run]
until = "1 s"
)toml" + numerics;
}

Fluid<2> fluid_of(const std::string& text) {
  const auto scene = scene::read_scene_text(text, "disk.toml");
  return Fluid<2>(scene, sph::fill<2>(scene));
}

// The transport velocity alone does not conserve momentum; what solid and fluid exchange must.
void check_momentum(const std::string& density) {
  auto fluid =
      fluid_of(disk(density, "initial_velocity = [\"2 m/s\", \"0.3 m/s\"]", "[effects]\ntransport_velocity = false\n"));
  const auto total = [&] { return Eigen::Vector2d(fluid.momentum() + fluid.solids().momentum()); };
  const auto before = total();
  const auto solid = fluid.solids().momentum();
  fluid.advance(0.3);
  EXPECT_LT((total() - before).norm(), 1e-12 * solid.norm()) << density;
  EXPECT_LT(fluid.solids().momentum().norm(), 0.9 * solid.norm()) << "the fluid should brake the disk";
}

TEST(Immersion, MomentumCloses) {
  check_momentum("1 kg/m^3");
  check_momentum("10 kg/m^3");
  check_momentum("0.2 kg/m^3");
}

TEST(Immersion, MomentumClosesInSpace) {
  const auto scene = scene::read_scene_text(R"toml(dimension = 3
[domain]
size = ["1 m", "1 m", "1 m"]
spacing = "0.09 m"
boundary = "periodic"
material = "liquid"
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.02 Pa s"
[materials.ball]
type = "solid"
density = "2 kg/m^3"
shear_modulus = "50 Pa"
poisson_ratio = 0.4
initial_velocity = ["1 m/s", "0.2 m/s", "-0.4 m/s"]
[[region]]
material = "ball"
shape = "ball"
center = ["0.5 m", "0.5 m", "0.5 m"]
radius = "0.25 m"
[effects]
transport_velocity = false
[run]
until = "1 s"
)toml",
                                            "ball.toml");
  Fluid<3> fluid(scene, sph::fill<3>(scene));
  const Eigen::Vector3d before = fluid.momentum() + fluid.solids().momentum(), solid = fluid.solids().momentum();
  for (int k = 0; k < 40; ++k) fluid.step();
  EXPECT_LT((fluid.momentum() + fluid.solids().momentum() - before).norm(), 1e-12 * solid.norm());
  EXPECT_LT(fluid.solids().momentum().norm(), 0.95 * solid.norm());
}

TEST(Immersion, SameBitsForAnyNumberOfThreads) {
  auto text = disk("2 kg/m^3", "");
  text.replace(text.find("spacing = \"0.05 m"), 17, "spacing = \"0.01 m");
  const auto run = [&](int threads) {
    omp_set_num_threads(threads);
    auto fluid = fluid_of(text);
    for (int k = 0; k < 10; ++k) fluid.step();
    omp_set_num_threads(1);
    return fluid.solids().bodies()[0].displacement;
  };
  EXPECT_EQ(run(1), run(5));
}

TEST(Immersion, StiffBodiesTakeShorterStepsThanTheFluid) {
  auto soft = fluid_of(disk("1 kg/m^3", ""));
  auto stiff = fluid_of(disk("1 kg/m^3", "", "").replace(disk("1 kg/m^3", "").find("100 Pa"), 6, "1e7 Pa"));
  EXPECT_EQ(soft.dt(), stiff.dt());
  EXPECT_LT(stiff.solids().step_limit(), 0.1 * stiff.dt());
  stiff.advance(0.02);
  EXPECT_LT(stiff.density_error(), 0.1);
}

TEST(Immersion, RefusesWhatItCannotDo) {
  EXPECT_THROW(fluid_of(disk("1 kg/m^3", "", "[numerics]\npressure = \"difference\"\n")), base::InputError);
  EXPECT_THROW(fluid_of(disk("1 kg/m^3", "", "[numerics]\nviscous_step = \"implicit\"\n")), base::InputError);
  auto noisy = disk("1 kg/m^3", "", "[effects]\nthermal_noise = true\ntransport_velocity = false\n");
  noisy.replace(noisy.find("[flow]"), 6, "[flow]\nthermal_energy = \"1e-6 J\"");
  EXPECT_THROW(fluid_of(noisy), base::InputError);
}

}  // namespace
}  // namespace shmoo::hydro::testing
