#include "hydro/pair_rows.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "base/random.hpp"

namespace shmoo::hydro {
namespace {

constexpr double reach = 0.2, skin = 0.03;

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
base::Box<D> unit_box(bool periodic) {
  base::Box<D> box;
  box.periodic.fill(periodic);
  return box;
}

template <int D>
std::vector<std::int32_t> partners_of(const sph::Particles<D>& particles, const base::Box<D>& box, std::size_t i,
                                      double cutoff) {
  std::vector<std::int32_t> found;
  const bool flows = particles.role[i] == sph::Role::fluid;
  for (std::size_t j = 0; j < particles.size(); ++j) {
    const double r = box.nearest(particles.position[i] - particles.position[j]).norm();
    if (j != i && r < cutoff && (flows || particles.role[j] == sph::Role::fluid)) found.push_back(std::int32_t(j));
  }
  return found;
}

template <int D>
void rows_hold_every_pair(bool periodic) {
  const auto box = unit_box<D>(periodic);
  auto particles = scattered<D>(300);
  PairRows<D> rows(box, reach, skin, 0.06);
  rows.build(particles);
  std::size_t at_walls = 0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto expected = partners_of(particles, box, i, reach + skin);
    const bool flows = particles.role[i] == sph::Role::fluid;
    ASSERT_EQ(flows, i < rows.blocks.fluid());
    if (flows && std::none_of(expected.begin(), expected.end(),
                              [&](std::int32_t j) { return particles.role[std::size_t(j)] == sph::Role::wall; })) {
      ASSERT_EQ(rows.count(i), 0u);
      continue;
    }
    const auto* row = rows.partner() + rows.first(i);
    ASSERT_EQ(std::vector<std::int32_t>(row, row + rows.count(i)), expected);
    at_walls += flows && !expected.empty();
  }
  EXPECT_EQ(rows.near_wall().size(), at_walls);
}

// Every pair once, at its distance; the copies that fill a block up aside.
template <int D>
void blocks_hold_every_pair(bool periodic) {
  const auto box = unit_box<D>(periodic);
  auto particles = scattered<D>(500);
  PairRows<D> rows(box, reach, skin, 0.06);
  rows.build(particles);
  const auto& blocks = rows.blocks;
  std::size_t seen = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::uint32_t l = 0; l < blocks[b].size; ++l, ++seen) {
      const std::size_t i = blocks[b].first + l;
      ASSERT_EQ(blocks.particle(lanes * b + l), i);
      std::vector<std::int32_t> found;
      for (std::uint32_t k = 0; k < blocks[b].partners; ++k) {
        const auto slot = std::size_t(blocks.partners(blocks[b])[k]);
        base::Vec<D> x;
        for (std::size_t a = 0; a < D; ++a) x[a] = blocks.coordinate[a][lanes * b + l] - blocks.coordinate[a][slot];
        const std::size_t j = blocks.particle(slot);
        if (!(x.norm() < reach + skin) || j == i) continue;
        found.push_back(std::int32_t(j));
        ASSERT_LT((box.nearest(particles.position[i] - particles.position[j]) - x).norm(), 1e-14);
      }
      std::sort(found.begin(), found.end());
      ASSERT_EQ(found, partners_of(particles, box, i, reach + skin));
    }
  }
  EXPECT_EQ(seen, blocks.fluid());
}

}  // namespace

TEST(PairRows, HoldEveryPairNearWalls) {
  rows_hold_every_pair<2>(false);
  rows_hold_every_pair<2>(true);
  rows_hold_every_pair<3>(false);
  rows_hold_every_pair<3>(true);
}

TEST(Blocks, HoldEveryPairOfFluid) {
  blocks_hold_every_pair<2>(false);
  blocks_hold_every_pair<2>(true);
  blocks_hold_every_pair<3>(false);
  blocks_hold_every_pair<3>(true);
}

TEST(PairRows, ServeUntilAParticleMovedHalfTheSkin) {
  auto particles = scattered<2>(50);
  PairRows<2> rows(unit_box<2>(true), 0.2, 0.1, 0.14);
  rows.build(particles);
  EXPECT_TRUE(rows.follow(particles));
  particles.position[7][0] += 0.049;
  EXPECT_TRUE(rows.follow(particles));
  particles.position[7][0] += 0.002;
  EXPECT_FALSE(rows.follow(particles));
}

// Across a periodic side too: the two views of a pair are opposite to the bit.
TEST(Blocks, SeparationsAreAntisymmetric) {
  auto particles = scattered<2>(200);
  PairRows<2> rows(unit_box<2>(true), 0.2, 0.03, 0.07);
  rows.build(particles);
  const auto& blocks = rows.blocks;
  std::map<std::pair<std::size_t, std::size_t>, double> seen;
  std::size_t both = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::uint32_t k = 0; k < blocks[b].partners; ++k) {
      const auto slot = std::size_t(blocks.partners(blocks[b])[k]);
      for (std::uint32_t l = 0; l < blocks[b].size; ++l) {
        const double x = blocks.coordinate[0][lanes * b + l] - blocks.coordinate[0][slot];
        const double y = blocks.coordinate[1][lanes * b + l] - blocks.coordinate[1][slot];
        const std::size_t i = blocks[b].first + l, j = blocks.particle(slot);
        if (!(std::hypot(x, y) < 0.2) || i == j) continue;
        seen[{i, j}] = x;
        if (const auto other = seen.find({j, i}); other != seen.end()) {
          ASSERT_EQ(other->second, -x);
          ++both;
        }
      }
    }
  }
  EXPECT_GT(both, 1000u);
}

}  // namespace shmoo::hydro
