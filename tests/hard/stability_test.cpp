#include "hard/cases.hpp"

namespace {

using namespace shmoo;

class Stability : public ::testing::TestWithParam<std::string> {};

TEST_P(Stability, EveryLawHolds) { test::expect_laws(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Quick, Stability, ::testing::ValuesIn(test::names_of_cases(false)), test::identifier);

// A law must be able to fail: numbers that are none, and numbers on the wrong side, break it.
TEST(Finding, HoldsInsideItsIntervalOnly) {
  using namespace run::verify;
  EXPECT_TRUE(at_most("x", 1.0, 1.0).holds());
  EXPECT_FALSE(at_most("x", 1.1, 1.0).holds());
  EXPECT_FALSE(at_least("x", 0.9, 1.0).holds());
  EXPECT_FALSE(exactly("x", 1.0 + 1e-12, 1.0).holds());
  EXPECT_FALSE(at_most("x", std::nan(""), 1.0).holds());
  EXPECT_FALSE(at_least("x", std::numeric_limits<double>::infinity(), 1.0).holds());
  EXPECT_FALSE(standard_errors("x", -5.1).holds());
}

}  // namespace
