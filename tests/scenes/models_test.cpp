// Every shipped model is read and runs for a short while; its ledger balances and its records are finite.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>

#include "memory_sink.hpp"

namespace {

using namespace shmoo;
namespace fs = std::filesystem;

std::vector<std::string> shipped_models() {
  std::vector<std::string> models;
  const fs::path root = fs::path(SHMOO_SOURCE_DIR) / "models";
  for (const auto& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() == ".toml" && !entry.path().filename().string().starts_with("study"))
      models.push_back(fs::relative(entry.path(), root).string());
  }
  std::sort(models.begin(), models.end());
  return models;
}

// How long each model is run; a new model needs a line.
const std::map<std::string, std::string> short_time{
    {"hes1/model.toml", "20 s"},
    {"minde/model.toml", "20 ms"},
    {"yeast-gradient/model.toml", "2 us"},
    {"yeast-gradient/diffusing-receptors.toml", "2 us"},
    {"yeast-gradient/published-4um.toml", "200 us"},
    {"yeast-projection/case-1.toml", "20 s"},
    {"yeast-projection/case-1-stochastic.toml", "20 s"},
    {"yeast-projection/case-2.toml", "20 s"},
    {"yeast-projection/control-pulse.toml", "20 s"},
    {"yeast-projection/published-explicit.toml", "0.05 us"},
    {"yeast-projection/small-cell.toml", "20 s"},
    {"yeast-polarization/model.toml", "0.1 s"},
    {"validation/annihilation-1d/model.toml", "0.01 s"},
    {"validation/beam/model.toml", "0.002 s"},
    {"validation/cylinder-re100/model.toml", "0.01 s"},
    {"validation/cylinder-re100/refined.toml", "0.01 s"},
    {"validation/diffusion-1d/model.toml", "0.01 s"},
    {"validation/diffusion-2d/model.toml", "0.1 s"},
    {"validation/dimerisation/model.toml", "1 us"},
    {"validation/fda-nozzle/model.toml", "0.1 ms"},
    {"validation/floating-cylinder/model.toml", "0.02 s"},
    {"validation/isochoric-box/model.toml", "0.02 s"},
    {"validation/microchannel-rod/model.toml", "2 us"},
    {"validation/cavity-3d/model.toml", "0.002 s"},
    {"validation/circular-couette/model.toml", "0.01 s"},
    {"validation/inclined-couette/model.toml", "0.01 s"},
    {"validation/lid-driven-cavity/model.toml", "0.01 s"},
    {"validation/natural-convection/model.toml", "0.02 s"},
    {"validation/poiseuille/model.toml", "0.01 s"},
    {"validation/pressurised-ring/model.toml", "1 s"},
    {"validation/pressurised-sphere/model.toml", "1 s"},
    {"validation/slow-channel/model.toml", "0.01 s"},
    {"validation/reversible-binding/model.toml", "0.01 s"},
    {"validation/taylor-green/model.toml", "0.01 s"},
    {"validation/thermal-noise/model.toml", "0.001 s"},
};

class ShippedModels : public testing::TestWithParam<std::string> {};

TEST_P(ShippedModels, RunsForAShortWhile) {
  ASSERT_TRUE(short_time.contains(GetParam())) << "add the model to the list of short times";
  const std::string time = "\"" + short_time.at(GetParam()) + "\"";
  const auto lab = test::laboratory(
      GetParam(),
      {{"run.until", time}, {"run.record_every", time}, {"run.record_at", "[]"}, {"run.realisations", "2"}});
  coupling::Outcome outcome;
  const auto sink = lab.realise(1, &outcome);
  EXPECT_TRUE(outcome.balanced);
  // With open sides, places that no particle has are no numbers.
  const auto& shared = lab.shared.fields();
  const auto vacant = [&](const std::string& name, std::size_t record, std::size_t entry, std::size_t entries) {
    const auto places = lab.experiment->particles();
    if (!shared.contains("position") || !shared.contains(name) || entries % places != 0) return false;
    const auto& position = shared.at("position").at(record);
    return std::isnan(position[entry / (entries / places) * (position.size() / places)]);
  };
  std::size_t records = 0;
  for (const auto* kind : {&lab.shared.fields(), &lab.shared.observables(), &sink.fields(), &sink.observables()}) {
    for (const auto& [name, by_time] : *kind) {
      EXPECT_EQ(by_time.size(), 2u) << name;
      for (const auto& [index, values] : by_time)
        for (std::size_t k = 0; k < values.size(); ++k)
          ASSERT_TRUE(std::isfinite(values[k]) || vacant(name, index, k, values.size())) << name;
      ++records;
    }
  }
  const auto& layout = lab.experiment->layout();
  EXPECT_EQ(records, layout.fields.size() + layout.observables.size());
}

std::string test_name(const testing::TestParamInfo<std::string>& model) {
  std::string name = model.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ShippedModels, testing::ValuesIn(shipped_models()), test_name);

TEST(ShippedModelsList, HoldsNoModelThatIsNotShipped) {
  const auto models = shipped_models();
  for (const auto& [model, time] : short_time) {
    EXPECT_NE(std::find(models.begin(), models.end(), model), models.end()) << model;
  }
}

}  // namespace
