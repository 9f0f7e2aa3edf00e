// Limits looked at before a run: well, doubtful and refused, each with its arithmetic and what to do.
#include "coupling/rules/limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "coupling/experiment.hpp"
#include "coupling/rules/decide.hpp"
#include "coupling/rules/settling.hpp"
#include "scene/read.hpp"

namespace shmoo::coupling {
namespace {

const char* const binding = R"toml(
dimension = 3
[domain]
size = ["10 um", "10 um", "10 um"]
spacing = "1 um"
[materials.gel]
type = "still"
[species.A]
diffusivity = "10 um^2/s"
initial = "10 molecules/um^3"
[species.B]
diffusivity = "10 um^2/s"
initial = "10 molecules/um^3"
[[reaction]]
equation = "A + B -> 0"
forward = "1 um^3/(s molecule)"
[run]
until = "1 s"
)toml";

const char* const channel = R"toml(
dimension = 2
depth = "1 um"
[domain]
size = ["20 um", "10 um"]
spacing = "1 um"
boundary = { x = "periodic", y = "wall" }
[materials.water]
type = "fluid"
density = "1000 kg/m^3"
viscosity = "1e-3 Pa s"
[materials.glass]
type = "wall"
[species.P]
in = ["water"]
diffusivity = "1000 um^2/s"
initial = "10 molecules/um^3"
[[region]]
shape = "box"
lower = ["5 um", "3 um"]
upper = ["9 um", "7 um"]
material = "glass"
[flow]
body_force = ["80 m/s^2", "0 m/s^2"]
[numerics]
steady_tolerance = 0.01
[run]
until = "1 s"
)toml";

const char* const bored = R"toml(
dimension = 3
[domain]
size = ["10 um", "16 um", "16 um"]
origin = ["0 um", "-8 um", "-8 um"]
spacing = "1 um"
material = "glass"
[materials.water]
type = "fluid"
density = "1000 kg/m^3"
viscosity = "1e-3 Pa s"
[materials.glass]
type = "wall"
[[region]]
shape = "revolved"
corners = [["-5 um", "0 um"], ["-5 um", "4 um"], ["15 um", "3 um"], ["15 um", "0 um"]]
material = "water"
[flow]
body_force = ["80 m/s^2", "0 m/s^2", "0 m/s^2"]
[run]
until = "1 s"
)toml";

std::vector<Limit> limits_of(const char* text, const scene::Overrides& overrides, const Pace& pace = {}) {
  const auto decided = decide(scene::read_scene_text(text, "test.toml", overrides));
  return judge_limits(decided.scene, decided.numbers, pace);
}

Limit limit(const std::string& name, const char* text, const scene::Overrides& overrides = {}, const Pace& pace = {}) {
  for (const auto& one : limits_of(text, overrides, pace))
    if (one.name.starts_with(name)) return one;
  throw std::out_of_range(name);
}

TEST(Limits, VoxelsTooSmallForABimolecularReaction) {
  // 0.2527 k/(D h) = 0.2527 x 1e-18/(2e-11 x 1e-6)
  const auto well = limit("voxels too small", binding);
  EXPECT_NEAR(well.value, 0.2527 * 1.0 / 20.0, 1e-5);
  EXPECT_EQ(well.standing(), Standing::ok);
  const auto doubtful = limit("voxels too small", binding, {{"reaction.0.forward", "\"20 um^3/(s molecule)\""}});
  EXPECT_EQ(doubtful.standing(), Standing::warn);
  EXPECT_NE(doubtful.suggestion.find("at least 2.5e-06 m"), std::string::npos) << doubtful.suggestion;
  const auto worthless = limit("voxels too small", binding, {{"reaction.0.forward", "\"1e4 um^3/(s molecule)\""}});
  EXPECT_EQ(worthless.standing(), Standing::refuse);
}

TEST(Limits, LikeMoleculesMeetTwiceAsOften) {
  const auto like = limit("voxels too small", binding, {{"reaction.0.equation", "2 A -> 0"}});
  EXPECT_NEAR(like.value, 2.0 * 0.2527 * 1.0 / 20.0, 1e-5);
}

TEST(Limits, InASlabTheNumberOfVoxelsCounts) {
  const scene::Overrides slab{{"dimension", "2"}, {"depth", "\"1 um\""}, {"domain.size", R"(["10 um", "10 um"])"}};
  const auto one = limit("voxels too small", binding, slab);
  EXPECT_NEAR(one.value, 1.0 / 20.0 * (std::log(100.0) / (4 * M_PI) + 0.1951 / 4), 1e-6);
}

TEST(Limits, VoxelsTooLargeForAFastReaction) {
  EXPECT_NEAR(limit("voxels too large", binding).value, 1.0 / std::sqrt(10.0 / 10.0), 1e-9);  // D = 10, k C = 10
  const auto coarse = limit("voxels too large", binding, {{"reaction.0.forward", "\"9 um^3/(s molecule)\""}});
  EXPECT_NEAR(coarse.value, 3.0, 1e-9);
  EXPECT_EQ(coarse.standing(), Standing::warn);
  EXPECT_NE(coarse.suggestion.find("at most 3.3e-07 m"), std::string::npos) << coarse.suggestion;
}

TEST(Limits, CellPecletNumberOfACarriedFlow) {  // U = 80 x 1e-10/8e-6 = 1 mm/s
  EXPECT_NEAR(limit("cell Peclet number of P", channel).value, 1.0, 1e-9);
  const auto upwind = limit("cell Peclet number of P", channel, {{"species.P.diffusivity", "\"100 um^2/s\""}});
  EXPECT_EQ(upwind.standing(), Standing::warn);
  EXPECT_NE(upwind.suggestion.find("at most 2e-07 m"), std::string::npos) << upwind.suggestion;
}

TEST(Limits, MachNumber) {
  EXPECT_EQ(limit("Mach", channel).standing(), Standing::ok);
  EXPECT_EQ(limit("Mach", channel, {{"flow.sound_speed", "\"5 mm/s\""}}).standing(), Standing::warn);
  EXPECT_EQ(limit("Mach", channel, {{"flow.sound_speed", "\"0.5 mm/s\""}}).standing(), Standing::refuse);
}

TEST(Limits, LayersInAWall) {
  EXPECT_EQ(limit("wall layers", channel).standing(), Standing::ok);
  const auto thin = limit("wall layers", channel, {{"region.0.upper", R"(["7 um", "7 um"])"}});
  EXPECT_EQ(thin.standing(), Standing::warn);
  EXPECT_NEAR(thin.value, 1.5, 1e-9);  // 3 wanted, 2 there
  EXPECT_NE(thin.suggestion.find("3e-06 m thick"), std::string::npos) << thin.suggestion;
}

TEST(Limits, ParticlesAcrossARoundBore) {
  const auto coarse = limit("particles wanted across", bored);
  EXPECT_EQ(coarse.standing(), Standing::warn);
  EXPECT_NEAR(coarse.value, 8.0 / 6.0, 1e-9);  // of the narrow end
  EXPECT_NE(coarse.suggestion.find("7.5e-07 m"), std::string::npos) << coarse.suggestion;
  EXPECT_EQ(limit("particles wanted across", bored, {{"domain.spacing", "\"0.5 um\""}}).standing(), Standing::ok);
}

TEST(Limits, SummedDensitiesWithoutNoise) {
  const auto trembling = limit("trembling", channel, {{"numerics.density", "\"summation\""}});
  EXPECT_EQ(trembling.standing(), Standing::warn);
  EXPECT_NE(trembling.suggestion.find("leave numerics.density out"), std::string::npos) << trembling.suggestion;
}

TEST(Limits, Neighbours) {
  EXPECT_EQ(limit("neighbours", channel).standing(), Standing::ok);
  EXPECT_EQ(limit("neighbours", channel, {{"numerics.reach", "1.6"}}).standing(), Standing::warn);
}

TEST(Limits, SplittingStep) {  // turnover 10 1/s
  EXPECT_EQ(limit("splitting", binding, {{"numerics.splitting_step", "\"1 ms\""}}).standing(), Standing::ok);
  const auto coarse = limit("splitting", binding, {{"numerics.splitting_step", "\"0.1 s\""}});
  EXPECT_EQ(coarse.standing(), Standing::warn);
  EXPECT_NE(coarse.suggestion.find("at most 0.002 s"), std::string::npos) << coarse.suggestion;
}

TEST(Limits, AFlowThatCouldNeverFinish) {
  std::string moving = channel;
  moving.erase(moving.find("steady_tolerance"), std::string("steady_tolerance = 0.01\n").size());
  const auto endless = limit("days of computing the flow", moving.c_str(), {{"run.until", "\"100 days\""}});
  EXPECT_EQ(endless.standing(), Standing::refuse);
  EXPECT_NE(endless.meaning.find("steps"), std::string::npos);
  EXPECT_NE(endless.suggestion.find("steady_tolerance"), std::string::npos);
  EXPECT_EQ(limit("days of computing the flow", channel, {{"run.until", "\"100 days\""}}).standing(), Standing::ok)
      << "it is steady after milliseconds";
  const Pace slow{.particle_steps = 1e3, .events = 1e3, .measured = true};
  EXPECT_GT(limit("days of computing the flow", channel, {}, slow).value,
            1e3 * limit("days of computing the flow", channel).value);
}

TEST(Limits, EventsThatCouldNeverBeDrawn) {
  const auto many =
      limit("days of drawing", binding, {{"species.A.initial", "\"1e9 molecules/um^3\""}, {"run.until", "\"1 h\""}});
  EXPECT_EQ(many.standing(), Standing::refuse);
  EXPECT_NE(many.suggestion.find("split"), std::string::npos);
  for (const auto& one : limits_of(
           binding,
           {{"species.A.initial", "\"1e9 molecules/um^3\""}, {"run.until", "\"1 h\""}, {"numerics.sampler", "split"}}))
    EXPECT_FALSE(one.name.starts_with("days of drawing"));
}

TEST(Limits, ARunBeyondALimitIsRefusedUnlessTheModelInsists) {
  const scene::Overrides supersonic{{"flow.sound_speed", "\"0.5 mm/s\""}};
  try {
    make_experiment(scene::read_scene_text(channel, "test.toml", supersonic));
    FAIL() << "accepted";
  } catch (const base::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("test.toml"), std::string::npos) << message;
    EXPECT_NE(message.find("Mach number is 2"), std::string::npos) << message;
    EXPECT_NE(message.find("at least 0.01 m/s"), std::string::npos) << message;
  }
  auto insisting = supersonic;
  insisting.emplace_back("numerics.limits", "warn");
  const auto notes = make_experiment(scene::read_scene_text(channel, "test.toml", insisting))->notes();
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const auto& n) { return n.starts_with("Mach number"); }));
}

TEST(Limits, AFlowThatIsSteadySoonIsForecastSo) {
  const auto decided = decide(scene::read_scene_text(channel, "test.toml"));
  const double viscous = 1e-10 / 1e-6;  // [s] L^2/nu
  const double settling = settling_time(decided.scene, decided.numbers);
  EXPECT_GT(settling, 0.5 * viscous);
  EXPECT_LT(settling, 2.0 * viscous);
}

}  // namespace
}  // namespace shmoo::coupling
