#include "scene/expression.hpp"

#include <gtest/gtest.h>

namespace shmoo::scene {
namespace {

using namespace base::dimensions;

const std::vector<Variable> variables{{"x", length, 0, 1e-5},
                                      {"t", base::dimensions::time, 0, 10},
                                      {"A", concentration, 1e9, 1e29, true},
                                      {"B", concentration, 1e9, 1e29, true},
                                      {"k", frequency, 0.3, 0.3},
                                      {"K", concentration, 1e18, 1e18},
                                      {"w", length, 1e-6, 1e-6},
                                      {"n", none, 2.5, 2.5}};

std::string problem(const std::string& text, const base::Dimension& dimension) {
  std::vector<std::string> names;
  for (const auto& variable : variables) names.push_back(variable.name);
  try {
    check_dimension(Expression(text, names), variables, dimension);
  } catch (const ExpressionError& error) {
    return error.what();
  }
  return "";
}

TEST(Expressions, OfTheRightDimensionPass) {
  const auto rate = concentration / base::dimensions::time;
  for (const char* text : {"k*A", "k*A*B/K", "k*A^n/(A^n + K^n)*K", "k*A*exp(-x/w)", "k*K*sin(2*_pi*x/w)",
                           "x < w ? k*A : 0", "0", "k*K*exp(-((x - 3*w)/w)^2)", "k*min(A, B)", "k*sqrt(A*B)", "A/t",
                           "k*A*(1 + tanh(k*t - 1))", "k*(A - B)", "k*A > k*B ? k*A : k*B"})
    EXPECT_EQ(problem(text, rate), "") << text;
}

TEST(Expressions, OfAnotherDimensionDoNot) {
  const auto rate = concentration / base::dimensions::time;
  for (const char* text : {"A", "k*A*B", "k", "1", "k*A + 1", "k*A*exp(-x)", "x < 1e-6 ? k*A : 0", "k*A^2/(A + 1e18)",
                           "k*A*n*t", "k*sqrt(A)", "k*A*sin(t)", "A/2", "1e20"})
    EXPECT_NE(problem(text, rate), "") << text;
}

TEST(Expressions, SayWhatIsWrong) {
  EXPECT_EQ(problem("q*A", concentration), "'q' is not defined; names here: x, t, A, B, k, K, w, n");
  EXPECT_EQ(problem("k*sen(x/w)", frequency),
            "'sen' is not defined; did you mean 'sin'? Names here: x, t, A, B, k, K, w, n");
  EXPECT_EQ(problem("A B", concentration).substr(0, 10), "Unexpected");
  EXPECT_NE(problem("A; B", concentration).find("does not belong there"), std::string::npos);
  EXPECT_EQ(problem("\"A\"", concentration), "a formula holds no text in quotes");
  EXPECT_EQ(problem("log(-1)*A", concentration),
            "the formula has no finite value at any of the points that were tried");
  EXPECT_NE(problem("A = B", concentration), "");
  EXPECT_EQ(problem("A == B ? A : B", concentration), "");
  EXPECT_NE(problem(std::string(20000, '('), concentration), "");
  EXPECT_NE(problem("", concentration), "");
}

TEST(Expressions, KnowWhatTheyUse) {
  const Expression expression("a*c", {"a", "b", "c"});
  EXPECT_TRUE(expression.uses(0));
  EXPECT_FALSE(expression.uses(1));
  EXPECT_TRUE(expression.uses(2));
  EXPECT_EQ(expression({2, 5, 7}), 14);
}

}  // namespace
}  // namespace shmoo::scene
