// What is said of elastic solids before a run and during it: runs that could never finish, solids too soft for their
// fluid, energy that rises; and that a signal ends an explicit run at its next step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/energy_law.hpp"
#include "coupling/laboratory.hpp"
#include "coupling/rules/limits.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

// Without a fluid, or in vortices of unit speed and density.
scene::Scene body(const std::string& modulus, const std::string& until, bool fluid = false,
                  const std::string& more = "") {
  const std::string swim = R"toml(
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.001 Pa s"
[parameters]
U = "1 m/s"
k = "6.283185307179586 1/m"
[flow]
initial_velocity = ["-U * cos(k*x) * sin(k*y)", "U * sin(k*x) * cos(k*y)"]
reference_speed = "1 m/s"
reference_length = "1 m"
)toml";
  const std::string material = fluid ? "\"liquid\"" : "\"nothing\"", sides = fluid ? "\"periodic\"" : "\"reflect\"";
  return scene::read_scene_text(
      "dimension = 2\ndepth = \"1 m\"\n[domain]\nsize = [\"1 m\", \"1 m\"]\nspacing = \"0.025 m\"\nmaterial = " +
          material + "\nboundary = " + sides +
          "\n[materials.body]\ntype = \"solid\"\ndensity = \"1 kg/m^3\"\npoisson_ratio = 0.4\nshear_modulus = \"" +
          modulus + "\"\n" + (fluid ? "" : "initial_velocity = [\"0.1 m/s\", \"0 m/s\"]\n") + more +
          "[[region]]\nmaterial = \"body\"\nshape = \"disk\"\ncenter = [\"0.5 m\", \"0.5 m\"]\nradius = \"0.15 m\"\n" +
          (fluid ? swim : "") + "[run]\nuntil = \"" + until + "\"\n",
      "body.toml");
}

Limit limit(const scene::Scene& scene, const std::string& name) {
  const auto limits = judge_limits(scene, numbers_of(scene));
  const auto found = std::find_if(limits.begin(), limits.end(),
                                  [&](const auto& one) { return one.name.find(name) != std::string::npos; });
  if (found == limits.end()) throw std::out_of_range(name);
  return *found;
}

// 112 particles at 0.94 ms a step, 2e7 particle-steps a second: 160 days are 2.3e12 s of motion.
TEST(SolidLimits, ARunThatCouldNeverFinishIsRefusedWithItsArithmetic) {
  const auto brief = limit(body("100 Pa", "1 s"), "computing the solids");
  EXPECT_EQ(brief.standing(), Standing::ok);
  const double day = 1.0 / brief.value;  // [s] of motion that take a day
  const auto scene = body("100 Pa", std::to_string(160.0 * day) + " s");
  const auto endless = limit(scene, "computing the solids");
  EXPECT_NEAR(endless.value, 160.0, 1e-3);
  EXPECT_EQ(endless.standing(), Standing::refuse);
  for (const char* word : {"a step (elastic waves)", "particles at", "160 days"})
    EXPECT_NE(endless.meaning.find(word), std::string::npos) << endless.meaning;
  EXPECT_THROW(enforce(scene, {endless}), base::InputError);
  EXPECT_EQ(limit(body("100 Pa", std::to_string(20.0 * day) + " s"), "computing the solids").standing(),
            Standing::warn);
}

TEST(SolidLimits, ASolidSofterThanItsFluidsPressuresIsDoubtful) {
  EXPECT_EQ(limit(body("2 Pa", "1 s", true), "modulus of body").standing(), Standing::ok);
  const auto soft = limit(body("0.1 Pa", "1 s", true), "modulus of body");
  EXPECT_NEAR(soft.value, 10.0, 1e-9);
  EXPECT_EQ(soft.standing(), Standing::warn);
}

double told_rise(const scene::Scene& scene, std::string* why = nullptr) {
  const Laboratory lab(scene);
  for (const auto& number : lab.experiment->derived()) {
    if (number.name != "largest rise of energy") continue;
    if (why) *why = number.why;
    return number.value;
  }
  return -1.0;
}

TEST(EnergyLaw, OfAFluidAndASolidThatNothingDrivesIsTold) {
  std::string why;
  EXPECT_LT(told_rise(body("10 Pa", "0.2 s", true), &why), 1e-3);
  EXPECT_EQ(why.find("WARNING"), std::string::npos);
}

TEST(EnergyLaw, KnowsWhatDrives) {
  EXPECT_TRUE(undriven(body("10 Pa", "1 s", true)));
  EXPECT_FALSE(undriven(body("10 Pa", "1 s")));  // no fluid: its laws are tested by themselves
  EXPECT_FALSE(undriven(body("10 Pa", "1 s", true, "body_force = [\"0 m/s^2\", \"-1 m/s^2\"]\n")));
}

TEST(EnergyLaw, WarnsOfARise) {
  EnergyLaw law;
  for (const double energy : {1.0, 0.8, 0.805}) law.look(energy);
  EXPECT_NEAR(law.rise(), 0.005, 1e-15);
  EXPECT_EQ(law.told().why.find("WARNING"), std::string::npos);
  law.look(0.9);
  EXPECT_NEAR(law.rise(), 0.1, 1e-15);
  EXPECT_NE(law.told().why.find("WARNING"), std::string::npos);
}

// One record, at the end; the run is asked at every step whether to go on.
TEST(SolidLimits, ASignalEndsAnExplicitRunAtItsNextStep) {
  const auto experiment = make_experiment(body("100 Pa", "1 s"));
  MemorySink sink(experiment->layout());
  int asked = 0;
  EXPECT_FALSE(experiment->prepare(sink, {[&] { return ++asked == 50; }, {}}));
  EXPECT_EQ(asked, 50);
}

}  // namespace
}  // namespace shmoo::coupling
