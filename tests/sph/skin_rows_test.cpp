// Rows with a skin hold every pair within reach wherever particles have moved to, and ascend.
#include "sph/skin_rows.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace {

using namespace shmoo;
using Vec = base::Vec<2>;

base::Box<2> unit_box(bool periodic) {
  base::Box<2> box;
  box.periodic = {periodic, false};
  return box;
}

std::vector<Vec> cloud(std::size_t n) {
  std::vector<Vec> points;
  base::RandomSequence random({7, 0}, base::Stream::test, 0);
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(random.uniform(), random.uniform());
  return points;
}

std::vector<std::uint32_t> within(const sph::NeighbourRows<2>& rows, std::size_t i, const std::vector<Vec>& x,
                                  const base::Box<2>& box, double reach) {
  std::vector<std::uint32_t> found;
  for (const auto j : rows.row(i))
    if (box.nearest(x[i] - x[j]).norm() < reach) found.push_back(j);
  return found;
}

void follow(double skin) {
  const auto box = unit_box(true);
  const double reach = 0.1;
  auto x = cloud(400);
  sph::SkinRows<2> skins(box, reach, skin);
  base::RandomSequence random({8, 0}, base::Stream::test, 0);
  for (int step = 0; step < 30; ++step) {
    const auto rows = skins.at(x);
    sph::NeighbourRows<2> fresh;
    fresh.build(x, box, reach);
    fresh.sort();
    for (std::size_t i = 0; i < x.size(); ++i) {
      const auto row = fresh.row(i);
      EXPECT_EQ(within(*rows, i, x, box, reach), std::vector<std::uint32_t>(row.begin(), row.end()));
    }
    for (auto& p : x) p = box.wrap(p + 0.006 * Vec(random.uniform() - 0.5, random.uniform() - 0.5));
  }
}

TEST(SkinRows, FollowMovingParticles) {
  follow(0.03);
  follow(0.0);
}

TEST(SkinRows, AreKeptWhileParticlesHardlyMove) {
  const auto box = unit_box(false);
  auto x = cloud(100);
  sph::SkinRows<2> skins(box, 0.1, 0.04);
  const auto first = skins.at(x);
  for (auto& p : x) p[0] += 0.015;
  EXPECT_EQ(skins.at(x), first);
  x[5][0] += 0.01;
  EXPECT_NE(skins.at(x), first);
}

}  // namespace
