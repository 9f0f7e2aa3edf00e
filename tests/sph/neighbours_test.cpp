// Neighbour rows against the search over all pairs, in boxes with few and many cells.
#include "sph/neighbours.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>

#include "base/random.hpp"

namespace {

using namespace shmoo;

template <int D>
std::vector<base::Vec<D>> scatter(const base::Box<D>& box, std::size_t n) {
  base::RandomSequence random({3, 0}, base::Stream::test);
  std::vector<base::Vec<D>> x(n);
  for (auto& p : x)
    for (int a = 0; a < D; ++a) p[a] = box.lower[a] + random.uniform() * (box.upper[a] - box.lower[a]);
  return x;
}

template <int D>
void check_against_all_pairs(base::Box<D> box, double cutoff, std::size_t n) {
  const auto x = scatter<D>(box, n);
  sph::NeighbourRows<D> rows;
  rows.build(x, box, cutoff);
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<std::uint32_t> expected;
    for (std::size_t j = 0; j < n; ++j) {
      if (j != i && box.nearest(x[i] - x[j]).norm() < cutoff) expected.push_back(static_cast<std::uint32_t>(j));
    }
    std::vector<std::uint32_t> found(rows.row(i).begin(), rows.row(i).end());
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected) << "particle " << i;
  }
}

TEST(Neighbours, EqualTheSearchOverAllPairs) {
  for (const bool periodic : {false, true}) {
    for (const double cutoff : {0.04, 0.2, 0.3, 0.45}) {
      base::Box<1> line;
      line.periodic = {periodic};
      check_against_all_pairs<1>(line, cutoff, 40);
      base::Box<2> square;
      square.periodic = {periodic, false};
      check_against_all_pairs<2>(square, cutoff, 150);
      base::Box<3> cube;
      cube.periodic = {periodic, true, false};
      check_against_all_pairs<3>(cube, cutoff, 200);
    }
  }
}

TEST(Neighbours, AreTheSameForAnyNumberOfThreads) {
  base::Box<2> box;
  box.periodic = {true, true};
  const auto x = scatter<2>(box, 500);
  std::vector<std::vector<std::uint32_t>> rows;
  const int before = omp_get_max_threads();
  for (const int threads : {1, 2, 5}) {
    omp_set_num_threads(threads);
    sph::NeighbourRows<2> found;
    found.build(x, box, 0.1);
    auto& flat = rows.emplace_back();
    for (std::size_t i = 0; i < x.size(); ++i) flat.insert(flat.end(), found.row(i).begin(), found.row(i).end());
  }
  omp_set_num_threads(before);
  EXPECT_EQ(rows[0], rows[1]);
  EXPECT_EQ(rows[0], rows[2]);
}

TEST(Neighbours, OfNoParticleAndOfOne) {
  sph::NeighbourRows<2> rows;
  rows.build({}, base::Box<2>{}, 0.1);
  EXPECT_EQ(rows.size(), 0u);
  const std::vector<base::Vec<2>> one{{0.5, 0.5}};
  rows.build(one, base::Box<2>{}, 0.1);
  EXPECT_EQ(rows.pairs(), 0u);
}

}  // namespace
