// shmoo verify on the command line.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "said.hpp"

namespace {

using namespace shmoo;

test::Said verify(std::vector<const char*> words) {
  words.insert(words.begin(), "verify");
  return test::say(std::move(words));
}

TEST(Verify, JudgesACaseAndSaysSoInJson) {
  const auto said = verify({"stability", "--case", "one-molecule", "--json"});
  EXPECT_EQ(said.code, run::exit_done) << said.err;
  const auto line = nlohmann::json::parse(said.out);
  EXPECT_EQ(line.at("case"), "one-molecule");
  EXPECT_TRUE(line.at("holds").get<bool>());
  EXPECT_EQ(line.at("laws").size(), 2u);
}

TEST(Verify, NamesItsCases) {
  const auto said = verify({"stability", "--list"});
  EXPECT_EQ(said.code, run::exit_done);
  EXPECT_NE(said.out.find("almost-coincident"), std::string::npos);
}

TEST(Verify, RefusesUnknownSuitesAndCases) {
  auto said = verify({"stabilty"});
  EXPECT_EQ(said.code, run::exit_input);
  EXPECT_NE(said.err.find("the suites are: chemistry, stability"), std::string::npos);
  said = verify({"stability", "--case", "nothing"});
  EXPECT_EQ(said.code, run::exit_input);
  EXPECT_NE(said.err.find("the cases are: disordered"), std::string::npos);
}

}  // namespace
