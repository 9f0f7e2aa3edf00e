// Formulas as trees: what is written back means what was read.
#include <gtest/gtest.h>

#include "base/random.hpp"
#include "scene/expression.hpp"
#include "scene/formula.hpp"

namespace shmoo::scene {
namespace {

const std::vector<std::string> names{"a", "b", "c"};

void expect_same(const std::string& text, const std::string& other) {
  const Expression one(text, names), two(other, names);
  base::RandomSequence random({}, base::Stream::test);
  for (int k = 0; k < 20; ++k) {
    const std::vector<double> at{random.uniform(), 3 * random.uniform(), 2 * random.uniform() - 1};
    EXPECT_EQ(one(at), two(at)) << text << " became " << other;
  }
}

TEST(Formula, MeansTheSameWhenWritten) {
  for (const char* text : {"a+b*c",
                           "(a+b)*c",
                           "a-(b-c)",
                           "a-b-c",
                           "a/(b*c)",
                           "a/b*c",
                           "-a^2",
                           "(-a)^2",
                           "2^-a",
                           "a^b^2",
                           "(a^b)^2",
                           "a<b ? c : -c",
                           "(a<b)*c",
                           "a<b && b<c || a>0.5",
                           "a<b && (b<c || a>0.5)",
                           "sin(a+b)*max(a, b, c)",
                           "1e-3*a",
                           "-a*-b",
                           "a - -b",
                           "(a < b ? 1 : 2) + c",
                           "a < b ? b < c ? 1 : 2 : 3",
                           "(a < b ? b : c) < 1 ? 4 : 5",
                           "a >= b == 1",
                           "floor(3*a) + ceil(b)"})
    expect_same(text, write(parse_formula(text)));
}

TEST(Formula, NamesAreReplacedAsWholes) {
  const auto changed = replace(parse_formula("2*a^b - ab"), {{"a", parse_formula("c + 1")}});
  EXPECT_EQ(write(changed), "2 * (c + 1)^b - ab");
}

TEST(Formula, WhatIsNoneIsRefused) {
  for (const char* text : {"", "a +", "(a", "a)", "f(a", "a ? b", "a b", "#"})
    EXPECT_THROW(parse_formula(text), ExpressionError) << text;
  EXPECT_THROW(parse_formula(std::string(100000, '(')), ExpressionError);
}

}  // namespace
}  // namespace shmoo::scene
