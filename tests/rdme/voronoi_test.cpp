// Laws of Voronoi faces: they close every cell, fill the box, are exact for linear profiles and converge at second
// order on disordered particles.
#include "rdme/voronoi.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/error.hpp"
#include "base/random.hpp"
#include "habitat_graph.hpp"

namespace {

using namespace shmoo;

template <int D>
struct Cloud {
  Cloud(int n, double jitter, std::array<bool, D> periodic, double size = 1.0) : spacing(size / n) {
    box.upper *= size;
    box.periodic = periodic;
    base::RandomSequence random({11, 0}, base::Stream::test);
    const int total = static_cast<int>(std::pow(n, D) + 0.5);
    for (int k = 0; k < total; ++k) {
      auto& x = position.emplace_back();
      for (int a = 0, rest = k; a < D; ++a, rest /= n) {
        x[a] = (rest % n + 0.5 + jitter * (2.0 * random.uniform() - 1.0)) * spacing;
      }
    }
  }
  rdme::VoronoiCells cells() const { return rdme::voronoi_cells<D>(position, {}, box, spacing); }

  double spacing;
  base::Box<D> box;
  std::vector<base::Vec<D>> position;
};

template <int D>
void check_cells(const Cloud<D>& cloud) {
  const auto faces = cloud.cells();
  double volume = 0.0;
  for (std::size_t i = 0; i < cloud.position.size(); ++i) {
    base::Vec<D> closure = base::Vec<D>::Zero();
    double gross = 0.0;
    for (std::uint64_t f = faces.first[i]; f < faces.first[i + 1]; ++f) {
      const base::Vec<D> x = cloud.box.nearest(cloud.position[faces.target[f]] - cloud.position[i]);
      closure += faces.weight[f] * x;
      gross += faces.weight[f] * x.norm();
      volume += faces.weight[f] * x.squaredNorm() / (2 * D);
      if (f > faces.first[i]) {
        EXPECT_LT(faces.target[f - 1], faces.target[f]);
      }
      const auto row =
          std::span(faces.target)
              .subspan(faces.first[faces.target[f]], faces.first[faces.target[f] + 1] - faces.first[faces.target[f]]);
      const auto back = std::find(row.begin(), row.end(), std::uint32_t(i));
      ASSERT_NE(back, row.end());
      EXPECT_EQ(faces.weight[f], faces.weight[faces.first[faces.target[f]] + std::uint64_t(back - row.begin())]);
    }
    EXPECT_LT(closure.norm(), 1e-9 * gross);
  }
  EXPECT_NEAR(volume / cloud.box.volume(), 1.0, 1e-9);  // pyramids over the faces fill the periodic box
  EXPECT_NEAR(std::accumulate(faces.volume.begin(), faces.volume.end(), 0.0) / cloud.box.volume(), 1.0, 1e-9);
}

TEST(Voronoi, CellsOfAPeriodicBoxCloseAndFillIt) {
  check_cells(Cloud<1>(12, 0.4, {true}));
  check_cells(Cloud<2>(12, 0.0, {true, true}));
  check_cells(Cloud<2>(12, 0.4, {true, true}));
  check_cells(Cloud<3>(8, 0.0, {true, true, true}));
  check_cells(Cloud<3>(8, 0.3, {true, true, true}));
  check_cells(Cloud<2>(12, 0.3, {true, true}, 1e-5));  // of a living cell, and of a lake
  check_cells(Cloud<3>(8, 0.3, {true, true, true}, 1e4));
}

// The steady profile C(x) = x between open sides, other axes reflecting: exact on any arrangement.
template <int D>
void check_linear(int n) {
  Cloud<D> cloud(n, 0.4, {});
  const std::vector<double> area(cloud.position.size(), std::pow(cloud.spacing, D));
  const std::vector<std::uint16_t> material(cloud.position.size(), 0);
  const rdme::Places<D> places{cloud.position, area, {}, material};
  rdme::Habitat habitat{{true}, {false}, {false}, {true}, {}};
  habitat.side[0] = habitat.side[1] = rdme::SideUse::open;
  const auto kernel = sph::make_kernel<D>(scene::Kernel::wendland_c2, 3.5 * cloud.spacing);
  const auto g = rdme::habitat_graph<D>(places, cloud.box, kernel, 1.0, habitat, rdme::PairWeights::faces);
  for (std::size_t i = 0; i < area.size(); ++i) {
    double net = 0.0, gross = 0.0;
    for (std::uint64_t p = g.graph.first[i]; p < g.graph.first[i + 1]; ++p) {
      const double flux = g.graph.coupling[p] * (cloud.position[g.graph.target[p]][0] - cloud.position[i][0]);
      net += flux;
      gross += std::abs(flux);
    }
    for (const auto& contact : g.contacts) {
      if (contact.voxel != i) continue;
      net += contact.exchange * ((contact.boundary == 1 ? 1.0 : 0.0) - cloud.position[i][0]);
      gross += contact.exchange;
    }
    EXPECT_NEAR(net, 0.0, 1e-9 * gross);
  }
}

TEST(Voronoi, LinearProfilesAreExactOnDisorderedParticles) {
  check_linear<1>(12);
  check_linear<2>(12);
  check_linear<3>(7);
}

// sin(pi x) sin(pi y) between open sides; the source that holds it, against its solution.
double source_error(int n, double jitter) {
  Cloud<2> cloud(n, jitter, {});
  const auto total = Eigen::Index(cloud.position.size());
  const std::vector<double> area = cloud.cells().volume;
  const std::vector<std::uint16_t> material(cloud.position.size(), 0);
  rdme::Habitat habitat{{true}, {false}, {false}, {true}, {}};
  habitat.side.fill(rdme::SideUse::open);
  const auto kernel = sph::make_kernel<2>(scene::Kernel::wendland_c2, 3.0 * cloud.spacing);
  const auto g = rdme::habitat_graph<2>({cloud.position, area, {}, material}, cloud.box, kernel, 1.0, habitat,
                                        rdme::PairWeights::faces);
  Eigen::MatrixXd L = Eigen::MatrixXd::Zero(total, total);
  Eigen::VectorXd source(total), exact(total);
  const double pi = std::numbers::pi;
  for (Eigen::Index i = 0; i < total; ++i) {
    const auto& x = cloud.position[std::size_t(i)];
    exact[i] = std::sin(pi * x[0]) * std::sin(pi * x[1]);
    source[i] = 2 * pi * pi * exact[i];
    for (std::uint64_t p = g.graph.first[std::size_t(i)]; p < g.graph.first[std::size_t(i) + 1]; ++p) {
      L(i, Eigen::Index(g.graph.target[p])) -= g.graph.coupling[p];
      L(i, i) += g.graph.coupling[p];
    }
  }
  for (const auto& contact : g.contacts) L(contact.voxel, contact.voxel) += contact.exchange;
  return (L.partialPivLu().solve(source) - exact).norm() / std::sqrt(double(total));
}

TEST(Voronoi, VacantPointsBoundTheCellsBesideAVoid) {
  Cloud<2> cloud(8, 0.0, {});
  std::vector<base::Vec<2>> kept, vacant;
  for (const auto& x : cloud.position) ((x - base::Vec<2>(0.5, 0.5)).norm() < 0.2 ? vacant : kept).push_back(x);
  ASSERT_FALSE(vacant.empty());
  const auto cells = rdme::voronoi_cells<2>(kept, vacant, cloud.box, cloud.spacing);
  ASSERT_EQ(cells.volume.size(), kept.size());
  for (const double volume : cells.volume) EXPECT_NEAR(volume, 1.0 / 64, 1e-12);
  for (const double weight : cells.weight) EXPECT_NEAR(weight, 1.0, 1e-9);
}

TEST(Voronoi, RefusesParticlesThatCoincideOrLieOutside) {
  Cloud<2> cloud(6, 0.2, {});
  cloud.position[7] = cloud.position[8];
  EXPECT_THROW(cloud.cells(), base::RunError);
  cloud = Cloud<2>(6, 0.2, {});
  cloud.position[7][1] = 1.01;
  EXPECT_THROW(cloud.cells(), base::RunError);
}

TEST(Voronoi, DiffusionConvergesAtSecondOrderOnDisorderedParticles) {
  const double coarse = source_error(8, 0.2), fine = source_error(16, 0.2), finest = source_error(32, 0.2);
  EXPECT_GT(std::log2(coarse / finest), 2 * 1.8);
  EXPECT_LT(fine, 3.0 * source_error(16, 0.0));
  EXPECT_LT(finest, 3.0 * source_error(32, 0.0));
}

}  // namespace
