// Laws of the jump rates: detailed balance, exact linear profiles between open sides, second order, carried volume.
#include "rdme/jump_graph.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/random.hpp"
#include "habitat_graph.hpp"

namespace {

using namespace shmoo;

// A lattice on the unit box, jittered by `jitter` spacings, with equal areas.
template <int D>
struct Lattice {
  explicit Lattice(int n, double jitter = 0.0, std::array<bool, D> periodic = {}) {
    box.periodic = periodic;
    base::RandomSequence random({7, 0}, base::Stream::test);
    const int total = static_cast<int>(std::pow(n, D) + 0.5);
    for (int k = 0; k < total; ++k) {
      base::Vec<D> x;
      for (int a = 0, rest = k; a < D; ++a, rest /= n) {
        x[a] = (rest % n + 0.5 + jitter * (2.0 * random.uniform() - 1.0)) / n;
      }
      position.push_back(x);
    }
    area.assign(position.size(), std::pow(1.0 / n, D));
    material.assign(position.size(), 0);
  }
  rdme::Places<D> places() const { return {position, area, drift, material}; }

  base::Box<D> box;
  std::vector<base::Vec<D>> position, drift;
  std::vector<double> area;
  std::vector<std::uint16_t> material;
};

rdme::Habitat everywhere() { return {{true}, {false}, {false}, {true}, {}}; }

// The generator of the mean: dC/dt = L C + b, with the given concentrations on open sides.
struct Generator {
  Eigen::MatrixXd L;
  Eigen::VectorXd b;
};
Generator generator(const rdme::HabitatGraph& g, std::size_t n, const std::array<double, 6>& held) {
  Generator result{Eigen::MatrixXd::Zero(int(n), int(n)), Eigen::VectorXd::Zero(int(n))};
  for (std::size_t i = 0; i < n; ++i) {
    for (std::uint64_t p = g.graph.first[i]; p < g.graph.first[i + 1]; ++p) {
      result.L(int(i), int(g.graph.target[p])) += g.graph.coupling[p];
      result.L(int(i), int(i)) -= g.graph.coupling[p];
    }
  }
  for (const auto& c : g.contacts) {
    result.L(int(c.voxel), int(c.voxel)) -= c.exchange;
    result.b[int(c.voxel)] += c.exchange * held[c.boundary];
  }
  return result;
}

template <int D>
void check_detailed_balance(const Lattice<D>& lattice, double reach) {
  auto unequal = lattice.area;
  for (std::size_t i = 0; i < unequal.size(); ++i) unequal[i] *= i % 3 == 0 ? 8.0 : 1.0;
  rdme::Places<D> places = lattice.places();
  places.area = unequal;
  const auto g =
      rdme::habitat_graph<D>(places, lattice.box, sph::make_kernel<D>(scene::Kernel::lucy, reach), 1.0, everywhere());
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < unequal.size(); ++i) {
    for (std::uint64_t p = g.graph.first[i]; p < g.graph.first[i + 1]; ++p) {
      const std::size_t j = g.graph.target[p];
      for (std::uint64_t q = g.graph.first[j]; q < g.graph.first[j + 1]; ++q) {
        if (g.graph.target[q] != i) continue;
        ++pairs;
        EXPECT_NEAR(unequal[i] * g.graph.coupling[p], unequal[j] * g.graph.coupling[q],
                    1e-12 * unequal[i] * g.graph.coupling[p]);
      }
    }
  }
  EXPECT_EQ(pairs, g.graph.target.size());
}

TEST(JumpGraph, ObeysDetailedBalanceForUnequalVolumes) {
  check_detailed_balance<1>(Lattice<1>(20, 0.3), 0.16);
  check_detailed_balance<2>(Lattice<2>(12, 0.3, {true, false}), 0.25);
  check_detailed_balance<3>(Lattice<3>(7, 0.2), 0.3);
}

TEST(JumpGraph, ALinearProfileBetweenOpenSidesIsExact) {
  for (const double reach : {1.2, 2.0, 3.0}) {
    Lattice<1> line(16);
    auto habitat = everywhere();
    habitat.side = {rdme::SideUse::open, rdme::SideUse::open};
    const auto g = rdme::habitat_graph<1>(line.places(), line.box, sph::make_kernel<1>(scene::Kernel::lucy, reach / 16),
                                          1.0, habitat);
    const auto G = generator(g, 16, {1.0, 0.0});
    const Eigen::VectorXd steady = G.L.partialPivLu().solve(-G.b);
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(steady[i], 1.0 - line.position[std::size_t(i)][0], 1e-12);
  }
}

// Exact solution of the slab C(0) = 1, C(1) = 0, C = 0 at t = 0 (separation of variables).
double slab(double x, double t, double kappa) {
  double c = 1.0 - x;
  for (int n = 1; n < 400; ++n) {
    const double k = n * std::numbers::pi;
    c -= 2.0 / k * std::sin(k * x) * std::exp(-k * k * kappa * t);
  }
  return c;
}

double slab_error(int n, double reach, scene::Kernel kernel, double t, double jitter = 0.0) {
  Lattice<1> line(n, jitter);
  auto habitat = everywhere();
  habitat.side = {rdme::SideUse::open, rdme::SideUse::open};
  const auto g = rdme::habitat_graph<1>(line.places(), line.box, sph::make_kernel<1>(kernel, reach / n), 1.0, habitat);
  const auto G = generator(g, std::size_t(n), {1.0, 0.0});
  const Eigen::VectorXd steady = G.L.partialPivLu().solve(-G.b);
  const Eigen::EigenSolver<Eigen::MatrixXd> modes(G.L);
  const Eigen::VectorXcd start = modes.eigenvectors().partialPivLu().solve((-steady).cast<std::complex<double>>());
  Eigen::VectorXcd factor = (modes.eigenvalues().array() * (0.1 * t)).exp().matrix();
  const Eigen::VectorXd c = steady + (modes.eigenvectors() * (start.cwiseProduct(factor))).real();
  double sum = 0.0;
  for (int i = 0; i < n; ++i) sum += std::pow(c[i] - slab(line.position[std::size_t(i)][0], t, 0.1), 2);
  return std::sqrt(sum / n);
}

TEST(JumpGraph, DiffusionInASlabConvergesAtSecondOrder) {
  for (const double t : {0.16, 1.0}) {
    for (const auto kernel : {scene::Kernel::lucy, scene::Kernel::wendland_c2, scene::Kernel::quintic_spline}) {
      for (const double reach : {1.2, 3.0}) {
        const double coarse = slab_error(16, reach, kernel, t), fine = slab_error(32, reach, kernel, t),
                     finest = slab_error(64, reach, kernel, t);
        EXPECT_GT(std::log2(coarse / fine), 1.7);
        EXPECT_GT(std::log2(fine / finest), 1.8);
      }
    }
  }
}

TEST(JumpGraph, AFluxSideReceivesItsWholeArea) {
  Lattice<2> square(10, 0.2);
  auto habitat = everywhere();
  habitat.side[2] = rdme::SideUse::flux;
  const auto g = rdme::habitat_graph<2>(square.places(), square.box,
                                        sph::make_kernel<2>(scene::Kernel::wendland_c2, 0.3), 0.5, habitat);
  double area = 0.0;
  for (const auto& c : g.contacts) {
    EXPECT_EQ(c.boundary, 2u);
    EXPECT_GT(c.area, 0.0);
    area += c.area;
  }
  EXPECT_NEAR(area, 0.5, 1e-12);
}

TEST(JumpGraph, TheCarriedVolumeIsAntisymmetricAndCanBeMadeDivergenceFree) {
  Lattice<2> square(16, 0.2, {true, false});
  for (const auto& x : square.position) {
    const double pi = std::numbers::pi;
    square.drift.emplace_back(-(1.0 + std::sin(2 * pi * x[0]) * std::cos(pi * x[1]) * pi),
                              2 * pi * std::cos(2 * pi * x[0]) * std::sin(pi * x[1]));
  }
  auto g = rdme::habitat_graph<2>(square.places(), square.box,
                                  sph::make_kernel<2>(scene::Kernel::wendland_c2, 3.0 / 16), 1.0, everywhere());
  EXPECT_NEAR(std::accumulate(g.graph.flow.begin(), g.graph.flow.end(), 0.0), 0.0, 1e-13);
  const double before = rdme::make_divergence_free(g.graph, square.area);
  EXPECT_LT(before, 0.2);
  EXPECT_GT(before, 1e-6);
  for (std::size_t i = 0; i < square.area.size(); ++i) {
    double net = 0.0;
    for (std::uint64_t p = g.graph.first[i]; p < g.graph.first[i + 1]; ++p) net += g.graph.flow[p];
    EXPECT_NEAR(net, 0.0, 1e-12);
  }
}

}  // namespace
