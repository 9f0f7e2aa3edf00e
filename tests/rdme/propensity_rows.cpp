// Totals and picks of many reactions, against adding them up one by one.
#include "rdme/samplers/propensity_rows.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "base/random.hpp"

namespace {

using namespace shmoo;

class Rows : public ::testing::TestWithParam<std::size_t> {};

TEST_P(Rows, TotalsAndPicksAreThoseOfAPlainList) {
  const std::size_t reactions = GetParam();
  constexpr std::size_t voxels = 3;
  rdme::PropensityRows rows;
  rows.clear(voxels, reactions);
  std::vector<std::vector<double>> plain(voxels, std::vector<double>(reactions, 0.0));
  base::RandomSequence random({1, 0}, base::Stream::test);
  for (int change = 0; change < 2000; ++change) {
    const std::size_t voxel = random() % voxels, reaction = random() % reactions;
    const double value = random() % 3 == 0 ? 0.0 : double(random() % 1000);  // whole numbers add up exactly
    plain[voxel][reaction] = value;
    rows.set(voxel, reaction, value);
    const double total = std::accumulate(plain[voxel].begin(), plain[voxel].end(), 0.0);
    ASSERT_EQ(rows.total(voxel), total);
    if (total == 0.0) continue;
    double rest = random.uniform() * total, left = rest, beyond = total;
    std::size_t wanted = 0;
    for (; left >= plain[voxel][wanted]; ++wanted) left -= plain[voxel][wanted];
    ASSERT_EQ(rows.pick(voxel, rest), wanted);
    ASSERT_NEAR(rest, left, 1e-9 * total);
    ASSERT_EQ(rows.pick(voxel, beyond), reactions);
  }
}

INSTANTIATE_TEST_SUITE_P(Reactions, Rows, ::testing::Values(1, 2, 8, 9, 16, 100));

}  // namespace
