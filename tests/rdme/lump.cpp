// Lumped voxels: what adds up adds up, and a gradient over many of them carries the flux that it should.
#include "rdme/lump.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "lattice.hpp"

namespace shmoo::rdme {
namespace {

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(Lumps, OfFewVoxelsAreTheVoxels) {
  const auto fine = lattice({4, 3, 2}, false, 2.0, 1);
  const auto lumps = lump(fine, 24, {});
  EXPECT_EQ(lumps.voxels.volume, fine.volume);
  EXPECT_EQ(sum(lumps.voxels.graphs[0].coupling), sum(fine.graphs[0].coupling));
}

TEST(Lumps, KeepVolumeAndDetailedBalance) {
  const auto fine = lattice({12, 10, 8}, true, 0.5, 1);
  const auto coarse = lump(fine, 100, {12.0, 10.0, 8.0}).voxels;
  EXPECT_LE(coarse.size(), 100u);
  EXPECT_GT(coarse.size(), 10u);
  EXPECT_NEAR(sum(coarse.volume), sum(fine.volume), 1e-9);
  const auto& graph = coarse.graphs[0];
  const auto conductance = [&](std::size_t i, std::size_t j) {
    for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p)
      if (graph.target[p] == j) return coarse.volume[i] * graph.coupling[p];
    return 0.0;
  };
  for (std::size_t i = 0; i < coarse.size(); ++i)
    for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p)
      EXPECT_NEAR(conductance(i, graph.target[p]), conductance(graph.target[p], i), 1e-12);
}

// Along a rod the resistance between the first and the last centre is their distance over the cross-section.
TEST(Lumps, CarryTheFluxOfAGradient) {
  const auto coarse = lump(lattice({60, 1, 1}, false, 1.0, 1), 10, {}).voxels;
  const auto& graph = coarse.graphs[0];
  double resistance = 0.0;
  for (std::size_t i = 0; i + 1 < coarse.size(); ++i) {
    const auto p = graph.first[i + 1] - 1;
    ASSERT_EQ(graph.target[p], i + 1);
    resistance += 1.0 / (coarse.volume[i] * graph.coupling[p]);
  }
  EXPECT_NEAR(resistance, coarse.position.back()[0] - coarse.position.front()[0], 1e-9);
}

TEST(Lumps, NeverJoinMaterials) {
  auto fine = lattice({16, 16, 1}, false, 1.0, 1);
  for (std::size_t i = 0; i < fine.size(); i += 3) fine.material[i] = 1;
  const auto lumps = lump(fine, 20, {});
  for (std::size_t i = 0; i < fine.size(); ++i) EXPECT_EQ(lumps.voxels.material[lumps.of[i]], fine.material[i]);
}

TEST(Lumps, KeepTheAreaOfASurfaceAndWhatEnters) {
  auto fine = lattice({20, 2, 1}, false, 1.0, 1);
  Surface surface{{0, 1}, {0}, {}, {}, {}};
  for (std::uint32_t i = 0; i < fine.size(); ++i) {
    fine.material[i] = i < 20 ? 0 : 1;
    if (i < 20) surface.target.push_back(i + 20), surface.area.push_back(0.5), surface.share.push_back(1.0);
    surface.first.push_back(surface.target.size());
    if (i % 20 == 0) fine.exchanges.push_back({i, 0, 3.0, 7.0});
  }
  fine.surfaces.push_back(surface);
  const auto coarse = lump(fine, 8, {}).voxels;
  EXPECT_NEAR(sum(coarse.surfaces[0].area), 10.0, 1e-12);
  double entering = 0.0, leaving = 0.0;
  for (const auto& one : coarse.exchanges) {
    entering += one.entry_rate;
    leaving += one.exit_rate * coarse.volume[one.voxel];
  }
  EXPECT_NEAR(entering, 14.0, 1e-12);
  EXPECT_NEAR(leaving, 6.0, 1e-12);
}

}  // namespace
}  // namespace shmoo::rdme
