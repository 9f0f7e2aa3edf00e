// What `shmoo explain` forecasts of every shipped model, against the run itself on the same machine: time within 25 %,
// memory within 10 %; and it takes at most 5 s to say so.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../scratch.hpp"

namespace shmoo::run {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> shipped_models() {
  std::vector<std::string> models;
  const fs::path root = fs::path(SHMOO_SOURCE_DIR) / "models";
  for (const auto& entry : fs::recursive_directory_iterator(root))
    if (entry.path().extension() == ".toml" && !entry.path().filename().string().starts_with("study"))
      models.push_back(fs::relative(entry.path(), root).string());
  std::sort(models.begin(), models.end());
  return models;
}

struct Spent {
  int code = -1;
  double seconds = 0;  // CPU time
  double bytes = 0;    // the most resident
};

// Runs the program as a process of its own, its output into a file.
Spent call(std::vector<std::string> words, const fs::path& output) {
  const pid_t child = fork();
  if (child == 0) {
    if (!freopen(output.c_str(), "w", stdout)) _exit(99);
    words.insert(words.begin(), SHMOO_PROGRAM);
    std::vector<char*> argv;
    for (auto& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execv(SHMOO_PROGRAM, argv.data());
    _exit(99);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return {WEXITSTATUS(status), seconds(usage.ru_utime) + seconds(usage.ru_stime), 1024.0 * double(usage.ru_maxrss)};
}

class ForecastOf : public testing::TestWithParam<std::string> {};

TEST_P(ForecastOf, AgreesWithTheRun) {
  const Scratch scratch;
  const auto model = std::string(SHMOO_SOURCE_DIR) + "/models/" + GetParam();
  const auto told = scratch / "told.json";
  const auto explaining = call({"explain", model, "--json", "--threads", "1"}, told);
  ASSERT_EQ(explaining.code, 0);
  EXPECT_LE(explaining.seconds, 5.0);  // CPU time: what else the machine does is not its own
  std::ifstream file(told);
  const auto forecast = nlohmann::json::parse(file).at("forecast");
  const auto result = (scratch / "out.h5").string();
  const auto spent = call({"run", model, "-o", result, "--threads", "1", "--quiet"}, scratch / "log");
  ASSERT_EQ(spent.code, 0);
  const double seconds = forecast.at("cpu_seconds"), bytes = forecast.at("bytes");
  std::printf(
      "%-40s CPU %8.3g s, forecast %8.3g s (%+.0f %%); memory %6.3g MB, forecast %6.3g MB (%+.0f %%); explained in "
      "%.2g s\n",
      GetParam().c_str(), spent.seconds, seconds, 100 * (seconds / spent.seconds - 1), 1e-6 * spent.bytes, 1e-6 * bytes,
      100 * (bytes / spent.bytes - 1), explaining.seconds);
  constexpr double start = 0.05;  // [s] of starting the program and writing the file
  EXPECT_NEAR(seconds, spent.seconds, 0.25 * spent.seconds + start);
  EXPECT_NEAR(bytes, spent.bytes, 0.10 * spent.bytes);
}

std::string test_name(const testing::TestParamInfo<std::string>& model) {
  std::string name = model.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, ForecastOf, testing::ValuesIn(shipped_models()), test_name);

}  // namespace
}  // namespace shmoo::run
