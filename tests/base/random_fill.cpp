// Many random words at a time are the words that one draws one by one.
#include <gtest/gtest.h>

#include <vector>

#include "base/random.hpp"

namespace shmoo::base {
namespace {

TEST(RandomFill, GivesTheSameWords) {
  for (std::size_t blocks : {1U, 7U, 8U, 9U, 40U}) {
    RandomSequence one({5, 2}, Stream::test, 123456789012345, 7, 8), many = one;
    for (int round = 0; round < 3; ++round) {
      std::vector<std::uint32_t> words(4 * blocks);
      many.fill(words.data(), blocks);
      for (std::uint32_t word : words) ASSERT_EQ(word, one());
    }
    EXPECT_EQ(many(), one());
  }
}

}  // namespace
}  // namespace shmoo::base
