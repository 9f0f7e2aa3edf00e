// The chances that `shmoo verify chemistry` finds are uniform over seeds where the laws hold: a Kolmogorov-Smirnov test
// of each check, and of all of a case together. One test for each case, by its name: long_run
// --gtest_filter='*ChancesAreUniform*first_order'. SHMOO_FIRST_SEED=5001 looks at other seeds. What makes a test itself
// fail by chance: 1e-6 for a case, and 1e-6 for each check. Chances of counts are only nearly uniform, as chi-square is
// a limit of many counts; with cells that expect five or more that is far nearer than these seeds can tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "run/verify/case.hpp"

namespace {

using namespace shmoo::run::verify;

constexpr std::uint64_t seeds = 60;

std::uint64_t first_seed() {
  const char* wanted = std::getenv("SHMOO_FIRST_SEED");
  return wanted ? std::strtoull(wanted, nullptr, 10) : 1001;
}

// The chance of a larger distance of n uniform numbers from their law (Kolmogorov 1933; Stephens' correction 1970).
double chance_of_distance(double distance, double n) {
  const double x = (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance;
  double sum = 0.0;
  for (int k = 1; k <= 100; ++k) sum += (k % 2 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
  return x < 0.2 ? 1.0 : std::clamp(sum, 0.0, 1.0);
}

double kolmogorov_smirnov(std::vector<double> chances) {
  std::sort(chances.begin(), chances.end());
  const double n = double(chances.size());
  double distance = 0.0;
  for (std::size_t k = 0; k < chances.size(); ++k)
    distance = std::max({distance, double(k + 1) / n - chances[k], chances[k] - double(k) / n});
  return chance_of_distance(distance, n);
}

class VerifyChemistry : public testing::TestWithParam<std::string> {};

TEST_P(VerifyChemistry, ChancesAreUniformOverSeeds) {
  std::map<std::string, std::vector<double>> by_check;
  std::vector<double> all;
  for (std::uint64_t seed = first_seed(), end = seed + seeds; seed < end; ++seed) {
    const auto cases = chemistry_cases(seed);
    const auto one = std::ranges::find(cases, GetParam(), &Case::name);
    ASSERT_NE(one, cases.end());
    for (const auto& finding : one->run()) {
      EXPECT_TRUE(finding.holds()) << finding.law << " at seed " << seed;
      if (finding.false_alarm == 0.0) continue;
      by_check[finding.law].push_back(finding.value);
      all.push_back(finding.value);
    }
  }
  for (const auto& [check, chances] : by_check) {
    const double chance = kolmogorov_smirnov(chances);
    std::printf("%-80s %zu chances, uniform with %.3g\n", check.c_str(), chances.size(), chance);
    EXPECT_GT(chance, 1e-6) << check;
  }
  const double chance = kolmogorov_smirnov(all);
  std::printf("all %zu chances of %s are uniform with %.3g\n", all.size(), GetParam().c_str(), chance);
  EXPECT_GT(chance, 1e-6);
}

std::vector<std::string> names() {
  std::vector<std::string> names;
  for (const auto& one : chemistry_cases(1))
    if (one.name != "min-oscillations") names.push_back(one.name);  // a period, not a chance
  return names;
}

INSTANTIATE_TEST_SUITE_P(Case, VerifyChemistry, testing::ValuesIn(names()), [](const auto& one) {
  std::string name = one.param;
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(c); }, '_');
  return name;
});

}  // namespace
