// What of a course swings: its range, its first period, its strongest oscillation, found in noise.
#include "run/study/oscillation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace shmoo::run {
namespace {

constexpr double amplitude = 0.16, period = 6.1;

Harmonic of_noisy_records(double noise, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> gauss(0.0, 1.0);
  std::vector<double> time, value;
  for (int k = 0; k < 49; ++k) {
    time.push_back(36.0 + 0.5 * k);
    value.push_back(0.7 + amplitude * std::sin(2.0 * std::numbers::pi * time.back() / period) + noise * gauss(engine));
  }
  return strongest_harmonic(time, value);
}

TEST(Harmonic, OfACleanSineIsExact) {
  const auto found = of_noisy_records(0.0, 1);
  EXPECT_NEAR(found.amplitude, amplitude, 1e-6);
  EXPECT_NEAR(found.period, period, 1e-4);
}

// The amplitude's standard deviation is noise sqrt(2/n), 0.02 here; six of them: a false alarm in 1e-8.
TEST(Harmonic, IsFoundInNoiseOfTwoThirdsOfIt) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const auto found = of_noisy_records(0.1, seed);
    EXPECT_NEAR(found.amplitude, amplitude, 0.12) << seed;
    EXPECT_NEAR(found.period, period, 0.6) << seed;
  }
}

TEST(FirstPeriod, EndsWhereAWholeSwingDoes) {
  const std::vector<double> time = {0, 1, 2, 3, 4, 5, 6, 7, 8}, value = {0, 2, 0, -2, 0, 2, 0, -2, 0};
  EXPECT_DOUBLE_EQ(first_period(time, value), 4.0);
  EXPECT_DOUBLE_EQ(half_range(value), 2.0);
  EXPECT_TRUE(std::isinf(first_period(std::span(time).first(3), std::span(value).first(3))));
}

}  // namespace
}  // namespace shmoo::run
