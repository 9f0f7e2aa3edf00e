// shmoo explain on shipped models: what it says, as text and as JSON.
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "run/command_line.hpp"

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
                           {"--set", "effects.default=auto", "--set", "effects.thermal_noise=\"auto\""});
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
  const auto text = explain("validation/reversible-binding/model.toml");
  for (const char* part :
       {"decisions\n", "numbers\n", "limits\n", "species.A.method", "voxels too small for A + B <-> C"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace shmoo::run
