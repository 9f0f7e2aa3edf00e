#pragma once
// What the command line says to a verb and its words.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <vector>

#include "run/command_line.hpp"

namespace shmoo::test {

struct Said {
  int code;
  std::string out, err;
};

inline Said say(std::vector<const char*> words) {
  words.insert(words.begin(), "shmoo");
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  const int code = run::command_line(int(words.size()), words.data(), run::Workshop{});
  std::fflush(stdout);
  return {code, testing::internal::GetCapturedStdout(), testing::internal::GetCapturedStderr()};
}

}  // namespace shmoo::test
