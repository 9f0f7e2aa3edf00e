// The chances that `shmoo verify chemistry` finds are uniform over seeds where the laws hold: a Kolmogorov-Smirnov test
// of all of them together, and of each check alone. What makes the test itself fail by chance: 1e-6 for all together,
// and 1e-6 for each check. Chances of counts are only nearly uniform, as chi-square is a limit of many counts; with
// cells that expect five or more that is far nearer than these seeds can tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "run/verify/case.hpp"

namespace {

using namespace shmoo::run::verify;

constexpr std::uint64_t seeds = 60;

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

TEST(VerifyChemistry, ChancesAreUniformOverSeeds) {
  std::map<std::string, std::vector<double>> by_check;
  std::vector<double> all;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    for (const auto& one : chemistry_cases(1000 + seed)) {
      if (one.name == "min-oscillations") continue;  // a period, not a chance
      for (const auto& finding : one.run()) {
        EXPECT_TRUE(finding.holds()) << one.name << ": " << finding.law << " at seed " << 1000 + seed;
        if (finding.false_alarm == 0.0) continue;
        by_check[one.name + ": " + finding.law].push_back(finding.value);
        all.push_back(finding.value);
      }
    }
  }
  for (const auto& [check, chances] : by_check) {
    const double chance = kolmogorov_smirnov(chances);
    std::printf("%-80s %zu chances, uniform with %.3g\n", check.c_str(), chances.size(), chance);
    EXPECT_GT(chance, 1e-6) << check;
  }
  const double chance = kolmogorov_smirnov(all);
  std::printf("all %zu chances are uniform with %.3g\n", all.size(), chance);
  EXPECT_GT(chance, 1e-6);
}

}  // namespace
