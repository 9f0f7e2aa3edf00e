#pragma once
#include <gtest/gtest.h>

#include <algorithm>

#include "run/verify/case.hpp"

namespace shmoo::test {

// Runs one case of `shmoo verify stability` and expects every law to hold.
inline void expect_laws(const std::string& name) {
  const auto cases = run::verify::stability_cases();
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const auto& one) { return one.name == name; });
  ASSERT_NE(found, cases.end());
  const auto findings = found->run();
  EXPECT_FALSE(findings.empty());
  for (const auto& finding : findings)
    EXPECT_TRUE(finding.holds()) << finding.law << ": " << finding.value << ", allowed " << finding.lowest << " .. "
                                 << finding.highest;
}

// Those that take longer than a few seconds run by name.
inline bool slow(const run::verify::Case& one) {
  if (one.by_name_only) return true;
  for (const char* name : {"vortices", "sudden-lid", "strong-noise", "runaway-force", "spinning-bar", "shots-at-walls",
                           "shots-in-space", "swinging-stream"})
    if (one.name == name) return true;
  return false;
}

inline std::vector<std::string> names_of_cases(bool slow_ones) {
  std::vector<std::string> names;
  for (const auto& one : run::verify::stability_cases())
    if (slow(one) == slow_ones) names.push_back(one.name);
  return names;
}

inline std::string identifier(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace shmoo::test
