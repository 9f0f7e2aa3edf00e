// shmoo explain on shipped models: what it says, as text and as JSON.
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "run/command_line.hpp"
#include "run/explain/coarse_wall.hpp"
#include "run/explain/forecast.hpp"

namespace shmoo::run {
namespace {

std::string explain(const std::string& model, std::vector<std::string> more = {}) {
  std::vector<std::string> words{"shmoo", "explain", std::string(SHMOO_SOURCE_DIR) + "/models/" + model};
  words.insert(words.end(), more.begin(), more.end());
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  ::testing::internal::CaptureStdout();
  const int code = command_line(static_cast<int>(argv.size()), argv.data());
  std::fflush(nullptr);
  const auto text = ::testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, exit_done);
  return text;
}

nlohmann::json told(const std::string& model, std::vector<std::string> more = {}) {
  more.emplace_back("--json");
  more.emplace_back("--unmeasured");
  return nlohmann::json::parse(explain(model, more));
}

nlohmann::json entry(const nlohmann::json& list, const std::string& key, const std::string& value) {
  for (const auto& one : list)
    if (one.at(key) == value) return one;
  return {};
}

TEST(Explain, TellsTheNumbersOfTheYeastGradientAsPublished) {
  const auto report = told("yeast-gradient/published-4um.toml");
  const auto value = [&](const std::string& name) {
    return entry(report.at("numbers"), "name", name).at("value").get<double>();
  };
  EXPECT_NEAR(value("Re"), 0.025, 1e-6);
  EXPECT_NEAR(value("Pe, L"), 72.05, 0.01);
  EXPECT_NEAR(value("Da, L"), 28.82, 0.01);
  EXPECT_NEAR(value("molecules per voxel, R"), 1600, 1e-6);
  EXPECT_EQ(entry(report.at("limits"), "name", "cell Peclet number of L").at("standing"), "warn");
}

TEST(Explain, SaysWhatAutoDecidesAndWhatTheRuleWouldSay) {
  const auto report = told("validation/thermal-noise/model.toml",
                           {"--set", "effects.default=auto", "--set", "effects.thermal_noise=\"auto\"", "--set",
                            "effects.transport_velocity=false"});
  const auto noise = entry(report.at("decisions"), "key", "effects.thermal_noise");
  EXPECT_EQ(noise.at("value"), "on");
  EXPECT_TRUE(noise.at("auto").get<bool>());
  const auto transport = entry(report.at("decisions"), "key", "effects.transport_velocity");
  EXPECT_EQ(transport.at("value"), "off");
  EXPECT_FALSE(transport.at("auto").get<bool>()) << "set by hand in the model";
  EXPECT_EQ(transport.at("by_rule"), "off");
}

TEST(Explain, HoldsEveryDerivedNumber) {
  const auto report = told("validation/poiseuille/model.toml");
  for (const char* name : {"time step", "sound speed", "step limit, viscosity", "reference speed"})
    EXPECT_TRUE(entry(report.at("derived"), "name", name).is_object()) << name;
}

TEST(Explain, TellsAWorthlessSceneInsteadOfRefusingIt) {
  const auto report = told("validation/poiseuille/model.toml", {"--set", "flow.sound_speed=0.5 m/s"});
  EXPECT_EQ(entry(report.at("limits"), "name", "Mach number").at("standing"), "refuse");
}

TEST(Explain, ReadsAsText) {
  const auto text = explain("validation/reversible-binding/model.toml", {"--threads", "1"});
  for (const char* part : {"decisions\n", "numbers\n", "limits\n", "forecast", "CPU time", "species.A.method",
                           "voxels too small for A + B <-> C"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

// What is measured on a flow of 400 particles.
nlohmann::json measured(std::vector<std::string> more = {}) {
  more.insert(more.end(), {"--json", "--threads", "1", "--set", "domain.spacing=0.05 m"});
  return nlohmann::json::parse(explain("validation/taylor-green/model.toml", more));
}

TEST(ExplainCosts, NamesThePresentEffectsWithTheirColumnsAndLimits) {
  const auto report = measured();
  const auto& effects = report.at("flow").at("effects");
  EXPECT_EQ(effects.size(), 4u);
  const auto room = entry(effects, "name", "closed room");
  EXPECT_TRUE(room.at("columns").empty());
  EXPECT_EQ(room.at("bytes"), 0u);
  const auto transport = entry(effects, "name", "transport velocity");
  EXPECT_EQ(transport.at("columns"), nlohmann::json{"shift_velocity"});
  EXPECT_EQ(transport.at("bytes"), 400 * 2 * sizeof(double));
  const auto viscosity = entry(effects, "name", "viscosity");
  EXPECT_GT(viscosity.at("step_limit").get<double>(), 0.0);
  EXPECT_FALSE(viscosity.at("rules").get<bool>()) << "sound does";
  double shares = 0.0;
  for (const auto& one : effects) shares += one.at("share").get<double>();
  EXPECT_LT(shares, 1.0);
}

TEST(ExplainCosts, AnAbsentEffectHasNoCost) {
  const auto report = measured({"--set", "effects.transport_velocity=false"});
  EXPECT_TRUE(entry(report.at("flow").at("effects"), "name", "transport velocity").is_null());
  EXPECT_LT(report.at("flow").at("column_bytes"), measured().at("flow").at("column_bytes"));
}

TEST(ExplainCosts, SaysWhichEffectRulesTheStep) {
  const auto report = measured({"--set", "materials.liquid.viscosity=1 Pa s"});
  const auto viscosity = entry(report.at("flow").at("effects"), "name", "viscosity");
  EXPECT_TRUE(viscosity.at("rules").get<bool>());
  EXPECT_GT(viscosity.at("step_without"), report.at("flow").at("step"));
}

TEST(ExplainForecast, CountsTheStepsOfTheFlow) {  // 0.0125 s an interval, 8 steps each
  EXPECT_NEAR(measured().at("forecast").at("flow_steps").get<double>(), 5.0 / 0.0125 * 8, 1.0);
}

// A rehearsal whose pace is known.
Rehearsal known(double end, double pace, double slope) {
  Rehearsal rehearsal;
  for (double f = 0.01; f <= end + 1e-9; f += 0.01)
    rehearsal.realised.push_back({f, 3.0 + pace * f + 0.5 * slope * f * f});
  for (auto& moment : rehearsal.realised)
    if (moment.fraction > 0.015) moment.seconds += 5.0;
  return rehearsal;
}

TEST(ExplainForecast, GoesOnAtASteadyPaceAndPaysListingsOnce) {
  const auto course = extrapolate(known(0.2, 10.0, 0.0), 1.0);
  EXPECT_NEAR(course.each, 10.0, 1e-9);
  EXPECT_NEAR(course.moving_once, 3.0, 1e-9);
  EXPECT_NEAR(course.standing_once, 5.0, 1e-9);
}

TEST(ExplainForecast, FollowsAPaceThatRisesUntilTheDomainIsFull) {
  // 10 + 20 f to f = 0.5, then even: 10/2 + 20/8 + 20/2.
  EXPECT_NEAR(extrapolate(known(0.2, 10.0, 20.0), 0.5).each, 17.5, 0.01);
  EXPECT_NEAR(extrapolate(known(0.2, 10.0, 20.0), 1.0).each, 20.0, 0.01);
}

TEST(ExplainForecast, AFinishedRehearsalIsTheAnswer) {
  auto finished = known(1.0, 10.0, 0.0);
  finished.finished = true;
  EXPECT_NEAR(extrapolate(finished, 1.0).each, 18.0, 1e-9);
}

TEST(ExplainForecast, AWallFollowsTheCourseOfACoarseOne) {
  const std::vector<Moment> coarse{{0.01, 1.0}, {0.1, 2.0}, {0.5, 3.0}, {1.0, 10.0}};
  EXPECT_NEAR(by_coarse({{0.005, 2.0}, {0.01, 4.0}}, coarse), 40.0, 1e-9);
  EXPECT_NEAR(by_coarse({{0.01, 4.0}, {0.055, 6.0}}, coarse), 40.0, 1e-9);
}

}  // namespace
}  // namespace shmoo::run
