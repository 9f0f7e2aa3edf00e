// Every file in tests/data/bad-models must be refused with exactly the messages beside it, one mistake a line.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/document.hpp"
#include "scene/read.hpp"

namespace shmoo::scene {
namespace {

const std::filesystem::path folder = SHMOO_SOURCE_DIR "/tests/data/bad-models";

std::vector<std::string> bad_models() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem());
  std::sort(names.begin(), names.end());
  return names;
}

std::string messages_of(const std::string& text, const std::string& file) {
  try {
    read_scene_text(text, file);
  } catch (const base::InputError& error) {
    return std::string(error.what()) + "\n";
  }
  return "accepted\n";
}

class BadModel : public testing::TestWithParam<std::string> {};

TEST_P(BadModel, IsRefusedWithItsMessages) {
  std::ifstream stream(folder / (GetParam() + ".expected"), std::ios::binary);
  ASSERT_TRUE(stream) << "there is no " << GetParam() << ".expected";
  std::ostringstream wanted;
  wanted << stream.rdbuf();
  const std::string file = GetParam() + ".toml";
  EXPECT_EQ(messages_of(read_bytes(folder / file), file), wanted.str());
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, BadModel, testing::ValuesIn(bad_models()), test_name);

TEST(BadModels, AreMany) { EXPECT_GE(bad_models().size(), 200u); }

TEST(BadFile, MissingOrDirectory) {
  const auto message = [](const std::string& file) -> std::string {
    try {
      read_scene(file);
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(message("/no/such/model.toml"),
            "/no/such/model.toml: error: there is no such file; give the path of a model file");
  EXPECT_EQ(message("/"), "/: error: this is a directory; give the path of a model file");
}

TEST(BadFile, TooLarge) {
  EXPECT_EQ(messages_of(std::string(17 * 1024 * 1024, '\n'), "big.toml"),
            "big.toml: error: the file is larger than 16 MiB, which no model file is\n");
}

TEST(BadFile, VeryManyMistakesAreCutShort) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "unknown_" + std::to_string(i) + " = 1\n";
  const std::string messages = messages_of(text, "many.toml");
  EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 101);
  EXPECT_NE(messages.find("more mistakes are not shown"), std::string::npos);
}

}  // namespace
}  // namespace shmoo::scene
