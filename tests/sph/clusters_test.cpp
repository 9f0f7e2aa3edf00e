// Clusters list every pair within reach wherever particles have moved to, images beyond sides among them, and both
// views of a pair are opposite to the bit.
#include "sph/clusters.hpp"

#include <gtest/gtest.h>

#include <map>

#include "base/random.hpp"
#include "sph/skin_lists.hpp"

namespace {

using namespace shmoo;
constexpr double reach = 0.17;

template <int D>
struct Pairs {
  std::multimap<std::pair<std::uint32_t, std::uint32_t>, base::Vec<D>>
      of;  // x_ij [m] of particles and images of the second
};

template <int D>
Pairs<D> listed(const sph::Clusters<D>& clusters, const std::vector<base::Vec<D>>& x) {
  Pairs<D> pairs;
  const auto at = clusters.coordinates(x);
  for (std::size_t c = 0; c < clusters.size(); ++c) {
    for (const std::uint32_t p : clusters.partners(c)) {
      for (std::size_t l = 0; l < clusters.count(c); ++l) {
        base::Vec<D> d;
        for (int a = 0; a < D; ++a) d[a] = at[std::size_t(a)][8 * c + l] - at[std::size_t(a)][p];
        if (d.norm() < reach) pairs.of.insert({{clusters.particle(8 * c + l), clusters.particle(p)}, d});
      }
    }
  }
  return pairs;
}

// By looking at every pair: particles themselves, images beyond sides that do not repeat, the nearest of those that do.
template <int D>
std::size_t looked_for(const base::Box<D>& box, const std::vector<base::Vec<D>>& x) {
  std::size_t found = 0;
  int ways = 1;
  for (int a = 0; a < D; ++a) ways *= 3;
  for (const auto& i : x) {
    for (const auto& j : x) {
      for (int way = 0; way < ways; ++way) {
        base::Vec<D> image = j;
        bool exists = true;
        for (int a = 0, rest = way; a < D; ++a, rest /= 3) {
          exists = exists && (rest % 3 == 0 || !box.periodic[std::size_t(a)]);
          if (rest % 3 > 0) image[a] = 2.0 * (rest % 3 == 1 ? box.lower[a] : box.upper[a]) - j[a];
        }
        found += exists && box.nearest(i - image).norm() < reach;
      }
    }
  }
  return found;
}

template <int D>
void follow(std::array<bool, D> periodic, std::size_t n, double skin) {
  base::Box<D> box;
  box.periodic = periodic;
  base::RandomSequence random({7, 0}, base::Stream::test, 0);
  std::vector<base::Vec<D>> x(n);
  for (auto& p : x)
    for (int a = 0; a < D; ++a) p[a] = random.uniform();
  sph::SkinLists<D, sph::Clusters<D>> skins(box, reach, skin);
  for (int step = 0; step < 8; ++step) {
    const auto pairs = listed<D>(*skins.at(x), x);
    EXPECT_EQ(pairs.of.size(), looked_for<D>(box, x)) << step;
    for (const auto& [ij, d] : pairs.of) {
      const auto [from, to] = pairs.of.equal_range({ij.second, ij.first});
      EXPECT_TRUE(std::any_of(from, to, [&, d = d](const auto& other) { return other.second.norm() == d.norm(); }));
    }
    for (auto& p : x) {
      for (int a = 0; a < D; ++a) {
        p[a] += 0.01 * (random.uniform() - 0.5);
        if (!periodic[std::size_t(a)]) p[a] = std::clamp(p[a], 0.0, 1.0);
      }
      p = box.wrap(p);
    }
  }
}

TEST(Clusters, ListAllPairsAndImages) {
  for (const double skin : {0.0, 0.03}) {
    follow<1>({false}, 37, skin);
    follow<1>({true}, 37, skin);
    follow<2>({true, false}, 150, skin);
    follow<2>({false, false}, 5, skin);
    follow<3>({true, true, false}, 200, skin);
  }
}

}  // namespace
