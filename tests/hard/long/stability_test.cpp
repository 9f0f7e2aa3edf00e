#include "hard/cases.hpp"

namespace {

using namespace shmoo;

class Stability : public ::testing::TestWithParam<std::string> {};

TEST_P(Stability, EveryLawHolds) { test::expect_laws(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Slow, Stability, ::testing::ValuesIn(test::names_of_cases(true)), test::identifier);

}  // namespace
