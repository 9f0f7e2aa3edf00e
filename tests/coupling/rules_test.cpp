// What "auto" decides on scenes whose right answer is known; where it may be wrong it warns.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "coupling/experiment.hpp"
#include "coupling/rules/decide.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

// Water in a channel 10 um wide, driven at about 1 mm/s, with a protein in it; everything left to the rules.
const char* const channel = R"toml(
dimension = 2
depth = "10 um"
[domain]
size = ["10 um", "10 um"]
spacing = "1 um"
boundary = { x = "periodic", y = "wall" }
[materials.water]
type = "fluid"
density = "1000 kg/m^3"
viscosity = "1e-3 Pa s"
[species.P]
diffusivity = "100 um^2/s"
initial = "10 nM"
[flow]
body_force = ["80 m/s^2", "0 m/s^2"]
temperature = "25 degC"
[effects]
default = "auto"
[numerics]
method = "auto"
[run]
until = "1 s"
)toml";

// A resting gel, 10 x 10 x 10 voxels of 1 um^3.
const char* const gel = R"toml(
dimension = 3
[domain]
size = ["10 um", "10 um", "10 um"]
spacing = "1 um"
[materials.gel]
type = "still"
[species.A]
diffusivity = "10 um^2/s"
initial = "100 molecules/um^3"
[effects]
default = "auto"
[numerics]
method = "auto"
[run]
until = "1 s"
)toml";

Decided decided(const char* text, const scene::Overrides& overrides = {}) {
  return decide(scene::read_scene_text(text, "test.toml", overrides));
}

const Decision& of(const Decided& all, const std::string& key) {
  const auto found =
      std::find_if(all.decisions.begin(), all.decisions.end(), [&](const auto& d) { return d.key == key; });
  if (found == all.decisions.end()) throw std::out_of_range(key);
  return *found;
}

TEST(Rules, ChannelOfWaterWithoutFineStructure) {
  const auto all = decided(channel);
  EXPECT_EQ(of(all, "effects.flow").value, "on");
  EXPECT_EQ(of(all, "effects.viscosity").value, "on");
  EXPECT_EQ(of(all, "effects.transport_velocity").value, "on");
  EXPECT_EQ(of(all, "effects.bounce_back").value, "on");
  EXPECT_EQ(of(all, "effects.species_advection").value, "on");
  EXPECT_EQ(of(all, "effects.thermal_noise").value, "off");
  EXPECT_FALSE(undecided(all.scene));
}

TEST(Rules, NoiseIsOffWhereItHardlySpreadsWhatIsCarriedAndSaysSo) {
  const auto noise = of(decided(channel), "effects.thermal_noise");
  EXPECT_GT(noise.number, 0.01);  // particles of 1e-14 kg: 0.9 mm/s
  EXPECT_NE(noise.warning.find("momentary velocities"), std::string::npos);
}

TEST(Rules, NoiseIsOnWhereVelocitiesAreRecorded) {
  const auto all = decided(channel, {{"run.record", R"(["velocity"])"}});
  EXPECT_EQ(of(all, "effects.thermal_noise").value, "on");
  EXPECT_EQ(of(all, "effects.transport_velocity").value, "off") << "it takes heat";
  EXPECT_EQ(of(all, "effects.density_diffusion").value, "off") << "density is summed";
}

TEST(Rules, NoiseIsOffWhereParticlesAreHeavy) {
  const auto all = decided(channel, {{"run.record", R"(["velocity"])"}, {"depth", "\"1 m\""}});
  EXPECT_EQ(of(all, "effects.thermal_noise").value, "off");
  EXPECT_LT(of(all, "effects.thermal_noise").number, 0.01);
  EXPECT_EQ(of(all, "effects.thermal_noise").warning, "");
}

TEST(Rules, NoiseIsOnWhereItSpreadsWhatIsCarried) {  // a bacterium's diffusivity on 50 nm particles
  const auto all = decided(channel, {{"domain.size", R"(["0.5 um", "0.5 um"])"},
                                     {"domain.spacing", "\"50 nm\""},
                                     {"species.P.diffusivity", "\"0.2 um^2/s\""}});
  EXPECT_EQ(of(all, "effects.thermal_noise").value, "on");
}

TEST(Rules, NoiseAloneMovesAFluidAtRest) {
  const auto all = decided(channel, {{"flow.body_force", R"(["0 m/s^2", "0 m/s^2"])"}});
  EXPECT_EQ(of(all, "effects.thermal_noise").value, "on");
  EXPECT_EQ(of(all, "effects.flow").value, "on");
}

TEST(Rules, WithoutATemperatureNoiseIsOffWithAWarningWhereItWouldMatter) {
  std::string cold = channel;
  cold.erase(cold.find("temperature"), std::string("temperature = \"25 degC\"\n").size());
  const auto fine = decided(cold.c_str(), {{"run.record", R"(["velocity"])"}});
  EXPECT_EQ(of(fine, "effects.thermal_noise").value, "off");
  EXPECT_NE(of(fine, "effects.thermal_noise").warning.find("give flow.temperature"), std::string::npos);
  const auto heavy = decided(cold.c_str(), {{"run.record", R"(["velocity"])"}, {"depth", "\"1 m\""}});
  EXPECT_EQ(of(heavy, "effects.thermal_noise").warning, "");
}

TEST(Rules, SlowFlowThatCarriesNothingFarIsLeftOut) {  // Pe = 1e-6 x 10/100
  const auto all = decided(channel, {{"flow.body_force", R"(["80e-6 m/s^2", "0 m/s^2"])"}});
  EXPECT_EQ(of(all, "effects.flow").value, "off");
  EXPECT_FALSE(all.scene.effects.viscosity);
  const auto watched =
      decided(channel, {{"flow.body_force", R"(["80e-6 m/s^2", "0 m/s^2"])"}, {"run.record", R"(["velocity"])"}});
  EXPECT_EQ(of(watched, "effects.flow").value, "on") << "it is what is looked at";
  EXPECT_EQ(of(watched, "effects.species_advection").value, "on") << "thermal noise carries";
}

TEST(Rules, AShortRunNeedsNeitherShiftsNorGuards) {  // a thousandth of a spacing
  const auto all = decided(channel, {{"run.until", "\"1 us\""}});
  EXPECT_EQ(of(all, "effects.transport_velocity").value, "off");
  EXPECT_EQ(of(all, "effects.bounce_back").value, "off");
}

TEST(Rules, WithoutWallsThereIsNoGuard) {
  const auto all = decided(channel, {{"domain.boundary", "periodic"}});
  EXPECT_EQ(of(all, "effects.bounce_back").value, "off");
}

TEST(Rules, DensityDiffusionGoesWhereViscosityDampsSound) {
  EXPECT_EQ(of(decided(channel), "effects.density_diffusion").value, "off");  // c0 hs/(4 nu) = 0.04
  const auto inviscid = decided(channel, {{"materials.water.viscosity", "\"1e-6 Pa s\""}});
  EXPECT_EQ(of(inviscid, "effects.density_diffusion").value, "on");
}

TEST(Rules, AFlowFinerThanASpacingIsWarnedOf) {
  const auto all = decided(channel, {{"materials.water.viscosity", "\"1e-6 Pa s\""}});
  EXPECT_EQ(of(all, "effects.viscosity").value, "on");
  EXPECT_NE(of(all, "effects.viscosity").warning, "");
}

TEST(Rules, NothingDrivesAGel) {
  const auto all = decided(gel);
  EXPECT_EQ(of(all, "effects.flow").value, "off");
  EXPECT_EQ(of(all, "effects.thermal_noise").value, "off");
  EXPECT_EQ(of(all, "effects.species_advection").value, "off");
}

TEST(Rules, WhatIsSetByHandStays) {
  const auto all = decided(channel, {{"effects.density_diffusion", "true"}, {"species.P.method", "deterministic"}});
  EXPECT_TRUE(all.scene.effects.density_diffusion);
  EXPECT_EQ(of(all, "effects.density_diffusion").by_rule, "off");
  EXPECT_FALSE(of(all, "effects.density_diffusion").automatic);
  EXPECT_EQ(all.scene.species[0].method, scene::SpeciesMethod::deterministic);
  EXPECT_EQ(of(all, "species.P.method").by_rule, "stochastic");
}

TEST(Rules, ExperimentsAreMadeOfDecidedScenesAndTellIt) {
  const auto experiment = make_experiment(scene::read_scene_text(gel, "test.toml"));
  EXPECT_FALSE(undecided(experiment->scene()));
  const auto notes = experiment->notes();
  EXPECT_NE(std::find_if(notes.begin(), notes.end(),
                         [](const auto& n) { return n.starts_with("species.A.method = stochastic (auto:"); }),
            notes.end());
  const auto derived = experiment->derived();
  EXPECT_NE(std::find_if(derived.begin(), derived.end(),
                         [](const auto& d) { return d.name == "effects.flow" && d.value == 0.0; }),
            derived.end());
}

TEST(Rules, EveryDecisionHasASourceAndAReason) {
  for (const auto& decision : decided(channel).decisions) {
    EXPECT_FALSE(decision.source.empty()) << decision.key;
    EXPECT_FALSE(decision.reason.empty()) << decision.key;
    EXPECT_FALSE(decision.looked_at.empty()) << decision.key;
  }
}

// ---- methods

std::string method(const scene::Overrides& overrides, const char* species = "A") {
  return of(decided(gel, overrides), fmt::format("species.{}.method", species)).value;
}

TEST(MethodRules, FewMoleculesAreSampled) { EXPECT_EQ(method({}), "stochastic"); }

TEST(MethodRules, ManyMoleculesAreSmooth) {
  EXPECT_EQ(method({{"species.A.initial", "\"1e5 molecules/um^3\""}}), "deterministic");
}

TEST(MethodRules, NothingNamedIsSampled) { EXPECT_EQ(method({{"species.A.initial", "\"0 M\""}}), "stochastic"); }

TEST(MethodRules, AGeneInOneVoxelIsSampledAndItsProteinIsNot) {
  const scene::Overrides gene{{"species.G", "{ method = \"auto\" }"},
                              {"initial", "[{ species = \"G\", count = \"1 molecule\" }]"},
                              {"reaction", "[{ equation = \"G -> G + A\", forward = \"1 1/s\" }]"},
                              {"species.A.initial", "\"1e5 molecules/um^3\""}};
  EXPECT_EQ(method(gene, "G"), "stochastic");
  EXPECT_EQ(method(gene, "A"), "deterministic");
}

TEST(MethodRules, ACountOfManyInOnePlaceIsSmooth) {
  EXPECT_EQ(method({{"initial", R"([{ species = "A", count = "1e8 molecules" }])"}}), "deterministic");
}

TEST(MethodRules, GrowthFromFewIsSampledHoweverManyItBecomes) {  // A -> 2 A from next to nothing in most voxels
  const scene::Overrides growth{
      {"species.A.initial", "\"0 M\""},
      {"initial",
       R"([{ species = "A", concentration = "1e6 molecules/um^3", shape = "box", lower = ["0 um", "0 um", "0 um"], upper = ["1 um", "10 um", "10 um"] }])"},
      {"reaction", R"toml([{ equation = "A + F -> 2 A", forward = "1e6 1/(M s)" }])toml"},
      {"species.F", R"({ initial = "1e6 molecules/um^3" })"}};
  EXPECT_EQ(method(growth), "stochastic");
  EXPECT_EQ(method(growth, "F"), "deterministic");
  auto plain = growth;
  plain[2].second = R"toml([{ equation = "A + F -> A", forward = "1e6 1/(M s)" }])toml";
  EXPECT_EQ(method(plain), "deterministic") << "without feedback the same numbers are smooth";
}

TEST(MethodRules, AHillFunctionThatFeedsItselfCountsAsGrowth) {
  const scene::Overrides feedback{
      {"species.A.initial", "\"5e3 molecules/um^3\""},
      {"parameters", R"toml({ v = "1e9 molecules/(um^3 s)", K = "1e4 molecules/um^3" })toml"},
      {"reaction", R"toml([{ equation = "0 -> A", rate = "v*A^2/(K^2 + A^2)" }])toml"}};
  EXPECT_EQ(method(feedback), "stochastic");
}

TEST(MethodRules, AProductTakesTheNumbersOfItsReactants) {
  const scene::Overrides product{{"species.A.initial", "\"1e5 molecules/um^3\""},
                                 {"species.B", "{}"},
                                 {"reaction", R"toml([{ equation = "A -> B", forward = "1 1/s" }])toml"}};
  EXPECT_EQ(method(product, "B"), "deterministic");
}

TEST(MethodRules, TheThresholdIsOnePerCent) {
  EXPECT_EQ(method({{"species.A.initial", "\"9.9e3 molecules/um^3\""}}), "langevin");
  EXPECT_EQ(method({{"species.A.initial", "\"1.01e4 molecules/um^3\""}}), "deterministic");
}

TEST(MethodRules, SmoothNoiseNeedsAThousandAndNoEmptyPlace) {
  EXPECT_EQ(method({{"species.A.initial", "\"1.01e3 molecules/um^3\""}}), "langevin");
  EXPECT_EQ(method({{"species.A.initial", "\"0.99e3 molecules/um^3\""}}), "stochastic");
  EXPECT_EQ(
      method(
          {{"species.A.initial", "\"99 molecules/um^3\""},
           {"initial",
            R"([{ species = "A", concentration = "5e3 molecules/um^3", shape = "box", lower = ["0 um", "0 um", "0 um"], upper = ["1 um", "10 um", "10 um"] }])"}}),
      "stochastic");
}

// ---- samplers

std::string sampler(scene::Overrides overrides, const char* initial) {
  overrides.insert(
      overrides.end(),
      {{"numerics.sampler", "\"auto\""}, {"species.A.method", "\"stochastic\""}, {"species.A.initial", initial}});
  return of(decided(gel, overrides), "numerics.sampler").value;
}

const scene::Overrides decay{{"reaction", R"toml([{ equation = "A -> nothing", forward = "1 1/s" }])toml"}};
const scene::Overrides pairing{{"reaction", R"toml([{ equation = "2 A -> nothing", forward = "1e4 um^3/(s molecule)" }])toml"},
                               {"species.A.diffusivity", "\"0 m^2/s\""}};

TEST(SamplerRules, FewEventsAreDrawnExactly) {
  EXPECT_EQ(sampler({{"run.until", "\"1 us\""}}, "\"10 molecules/um^3\""), "composition_rejection");
}

TEST(SamplerRules, ManyJumpsAreMadeWithoutEvents) {
  scene::Overrides longer = decay;
  longer.push_back({"run.until", "\"100 s\""});
  EXPECT_EQ(sampler(longer, "\"10 molecules/um^3\""), "split");
}

TEST(SamplerRules, ManyMoleculesThatReactAreLeaptOver) {
  EXPECT_EQ(sampler(pairing, "\"1e5 molecules/um^3\""), "tau_leaping");
  EXPECT_EQ(sampler(pairing, "\"10 molecules/um^3\""), "composition_rejection");
}

}  // namespace
}  // namespace shmoo::coupling
