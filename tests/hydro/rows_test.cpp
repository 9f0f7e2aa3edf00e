#include "hydro/pair_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/random.hpp"

namespace shmoo::hydro {
namespace {

template <int D>
sph::Particles<D> scattered(std::size_t count) {
  sph::Particles<D> particles;
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    base::RandomSequence random({5, 0}, base::Stream::test, 0, std::uint32_t(i));
    for (int a = 0; a < D; ++a) particles.position[i][a] = random.uniform();
    particles.id[i] = std::uint32_t(i);
    particles.role[i] = i % 4 == 0 ? sph::Role::wall : sph::Role::fluid;
  }
  return particles;
}

template <int D>
void holds_every_pair_within_reach(bool periodic) {
  base::Box<D> box;
  box.periodic.fill(periodic);
  auto particles = scattered<D>(300);
  PairRows<D> rows(box, 0.2, 0.03);
  rows.build(particles);
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    std::vector<std::int32_t> expected;
    const bool flows = particles.role[i] == sph::Role::fluid;
    for (std::size_t j = 0; j < particles.size(); ++j) {
      const double r = box.nearest(particles.position[i] - particles.position[j]).norm();
      if (j != i && r < 0.23 && (flows || particles.role[j] == sph::Role::fluid)) expected.push_back(std::int32_t(j));
    }
    const auto* row = rows.partner() + rows.first(i);
    std::vector<std::int32_t> found(row, row + rows.count(i));
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found, expected);
    ASSERT_EQ((rows.first(i + 1) - rows.first(i)) % lanes, 0u);
    for (std::uint64_t p = rows.first(i) + rows.count(i); p < rows.first(i + 1); ++p) {
      ASSERT_EQ(rows.partner()[p], std::int32_t(i));
    }
    pairs += rows.count(i);
  }
  EXPECT_EQ(rows.pairs(), pairs);
}

}  // namespace

TEST(PairRows, HoldEveryPairWithinReach) {
  holds_every_pair_within_reach<2>(false);
  holds_every_pair_within_reach<2>(true);
  holds_every_pair_within_reach<3>(false);
  holds_every_pair_within_reach<3>(true);
}

TEST(PairRows, AreOutdatedOnceAParticleMovedHalfTheSkin) {
  base::Box<2> box;
  box.periodic = {true, true};
  auto particles = scattered<2>(50);
  PairRows<2> rows(box, 0.2, 0.1);
  rows.build(particles);
  EXPECT_FALSE(rows.outdated(particles.position.values()));
  particles.position[7][0] += 0.049;
  EXPECT_FALSE(rows.outdated(particles.position.values()));
  particles.position[7][0] += 0.002;
  EXPECT_TRUE(rows.outdated(particles.position.values()));
}

}  // namespace shmoo::hydro
