// The exact laws that samplers are judged against, and the power of the judgement.
#include "run/verify/jump_chain.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "base/random.hpp"
#include "run/verify/case.hpp"

namespace {

using namespace shmoo;
using namespace shmoo::run::verify;

double poisson(double mean, std::size_t n) {
  return std::exp(double(n) * std::log(mean) - mean - std::lgamma(double(n) + 1.0));
}

// From nothing, birth and death is Poisson at all times.
TEST(JumpChain, TellsThePoissonLawOfBirthAndDeath) {
  std::vector<ChainJump> jumps;
  for (std::size_t n = 0; n < 90; ++n) {
    jumps.push_back({n, n + 1, 20.0});
    if (n > 0) jumps.push_back({n, n - 1, double(n)});
  }
  const auto law = chain_law(90, jumps, 0, 0.7);
  for (std::size_t n = 0; n < 60; ++n) EXPECT_NEAR(law[n], poisson(20.0 * (1.0 - std::exp(-0.7)), n), 1e-10);
}

TEST(JumpChain, BalancesUpsAndDowns) {
  const auto law = balanced_law(
      80, [](double) { return 6.0; }, [](double n) { return 2.0 * n; });
  for (std::size_t n = 0; n < 20; ++n) EXPECT_NEAR(law[n], poisson(3.0, n), 1e-12);
}

TEST(JumpChain, TellsAWrongLawFromTheRightOne) {
  base::RandomSequence random({3, 0}, base::Stream::test);
  std::vector<std::size_t> numbers;
  for (int k = 0; k < 4000; ++k) numbers.push_back(std::size_t(base::poisson(random, 20.0)));
  std::vector<double> right, wrong;
  for (std::size_t n = 0; n < 80; ++n) {
    right.push_back(poisson(20.0, n));
    wrong.push_back(poisson(20.6, n));  // 3 % off
  }
  EXPECT_GT(chance_of(right, numbers), 1e-6);
  EXPECT_LT(chance_of(wrong, numbers), 1e-6);
}

// The cases themselves, but the longest (all: `shmoo verify chemistry`, and long/uniform_chances.cpp at many seeds).
TEST(VerifyChemistry, EveryLawHolds) {
  const std::set<std::string> longest{"product-form", "first-order", "min-oscillations", "multinomial-0.1"};
  for (const auto& one : chemistry_cases(1)) {
    if (longest.contains(one.name)) continue;
    for (const auto& finding : one.run())
      EXPECT_TRUE(finding.holds()) << one.name << ": " << finding.law << ": " << finding.value;
  }
}

}  // namespace
