#include "base/nearest.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace shmoo::base {
namespace {

TEST(Nearest, DistanceCountsEditsAndSwaps) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("velocity", "velcoity"), 1u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
}

TEST(Nearest, SuggestsOnlyWhatIsNear) {
  const std::vector<std::string> names = {"velocity", "density", "L"};
  EXPECT_EQ(nearest_name("velocty", names), "velocity");
  EXPECT_EQ(nearest_name("temperature", names), "");
  EXPECT_EQ(did_you_mean("densty", names), "; did you mean 'density'?");
  EXPECT_EQ(list_of(names), "velocity, density, L");
  EXPECT_EQ(list_of({}), "(none)");
}

}  // namespace
}  // namespace shmoo::base
