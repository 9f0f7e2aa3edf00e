// Jumps that are not written down obey the couplings that are: the same sums and rows, targets in proportion to them,
// and under every sampler that takes them the same law.
#include "rdme/unlisted_jumps.hpp"

#include <numeric>

#include "habitat_graph.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

// Jittered particles on the unit box, one in seven of a material where the species does not live.
template <int D>
struct Cloud {
  base::Box<D> box;
  std::vector<base::Vec<D>> position;
  std::vector<double> area;
  std::vector<std::uint16_t> material;
  Habitat habitat{{true, false}, {false, false}, {false, false}, {true, false}, {}};

  Cloud(int n, std::array<bool, D> periodic) {
    box.periodic = periodic;
    base::RandomSequence random({3, 0}, base::Stream::test);
    const int total = static_cast<int>(std::pow(n, D) + 0.5);
    for (int k = 0; k < total; ++k) {
      base::Vec<D> x;
      for (int a = 0, rest = k; a < D; ++a, rest /= n) x[a] = (rest % n + 0.5 + 0.4 * (random.uniform() - 0.5)) / n;
      position.push_back(x);
      area.push_back(std::pow(1.0 / n, D) * (0.9 + 0.2 * random.uniform()));
      material.push_back(k % 7 == 3 ? 1 : 0);
    }
  }
  Places<D> places() const { return {position, area, {}, material}; }
};

template <int D>
void expect_equal_rows(scene::Kernel kind, int n, double reach, std::array<bool, D> periodic) {
  const Cloud<D> cloud(n, periodic);
  const auto kernel = sph::make_kernel<D>(kind, reach / n);
  const auto graph = habitat_graph<D>(cloud.places(), cloud.box, kernel, 1.0, cloud.habitat).graph;
  const auto clusters = std::make_shared<const sph::Clusters<D>>(cloud.position, cloud.box, (reach + 0.3) / n);
  const auto unlisted = make_unlisted_jumps<D>(cloud.places(), clusters, kernel, cloud.habitat);
  ASSERT_EQ(unlisted->size(), cloud.position.size());
  for (std::uint32_t i = 0; i < cloud.position.size(); ++i) {
    std::map<std::uint32_t, double> wanted, got;
    for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p) wanted[graph.target[p]] += graph.coupling[p];
    std::vector<std::uint32_t> target;
    std::vector<double> coupling;
    unlisted->row(i, target, coupling);
    for (std::size_t k = 0; k < target.size(); ++k) got[target[k]] += coupling[k];
    ASSERT_EQ(got.size(), wanted.size()) << i;
    double sum = 0.0;
    for (const auto& [j, c] : wanted) {
      EXPECT_NEAR(got[j], c, 1e-9 * c + 1e-12 * unlisted->sum(i)) << i << " to " << j;
      sum += c;
    }
    EXPECT_GE(unlisted->sum(i), sum * (1 - 1e-12)) << i;
    EXPECT_LE(unlisted->sum(i), 2 * sum + 1e-300) << i;
  }
}

TEST(UnlistedJumps, HaveTheRowsOfTheGraph) {
  using enum scene::Kernel;
  for (const auto kind : {lucy, cubic_spline, quintic_spline, wendland_c2})
    expect_equal_rows<2>(kind, 12, 3.0, {true, false});
  expect_equal_rows<1>(wendland_c2, 40, 3.0, {false});
  expect_equal_rows<1>(wendland_c2, 40, 3.0, {true});
  expect_equal_rows<2>(wendland_c2, 16, 2.6, {false, false});
  expect_equal_rows<3>(lucy, 8, 2.5, {true, false, false});
  expect_equal_rows<3>(wendland_c2, 8, 3.0, {true, true, true});
}

TEST(UnlistedJumps, LeadToTargetsInProportion) {
  const Cloud<2> cloud(10, {false, true});
  const auto kernel = sph::make_kernel<2>(scene::Kernel::wendland_c2, 0.3);
  const auto unlisted = make_unlisted_jumps<2>(
      cloud.places(), std::make_shared<const sph::Clusters<2>>(cloud.position, cloud.box, 0.33), kernel, cloud.habitat);
  WordStream words;
  for (const std::uint32_t i : {0u, 44u, 99u}) {
    words.open({{5, 0}, base::Stream::test, i});
    std::vector<std::uint32_t> target;
    std::vector<double> coupling, expected(100, 0.0), observed(100, 0.0);
    unlisted->row(i, target, coupling);
    constexpr int jumps = 200000;
    for (std::size_t k = 0; k < target.size(); ++k) expected[target[k]] += jumps * coupling[k] / unlisted->sum(i);
    expected[i] = std::max(0.0, jumps - std::accumulate(expected.begin(), expected.end(), 0.0));  // those that fail
    for (int k = 0; k < jumps; ++k) ++observed[unlisted->target(i, words)];
    EXPECT_GT(chi_square(observed, expected), false_alarm) << i;
    for (std::size_t j = 0; j < 100; ++j) EXPECT_TRUE(expected[j] > 0.0 || observed[j] == 0.0);
  }
}

class UnlistedSampling : public testing::TestWithParam<scene::Sampler> {
 protected:
  static scene::Scene scene() {
    scene::Scene scene = water();
    add_species(scene, "A", 1.0);
    return scene;
  }
  static Voxels voxels(bool listed) {
    Cloud<2> cloud(6, {false, false});
    cloud.material.assign(36, 0);
    const auto kernel = sph::make_kernel<2>(scene::Kernel::wendland_c2, 0.4);
    Voxels voxels;
    voxels.volume = cloud.area;
    voxels.material = cloud.material;
    for (const auto& x : cloud.position) voxels.position.push_back({x[0], x[1], 0.0});
    voxels.graph_of_species = {0};
    voxels.graphs.resize(1);
    if (listed) {
      voxels.graphs[0] = habitat_graph<2>(cloud.places(), cloud.box, kernel, 1.0, cloud.habitat).graph;
      return voxels;
    }
    voxels.unlisted = {make_unlisted_jumps<2>(cloud.places(),
                                              std::make_shared<const sph::Clusters<2>>(cloud.position, cloud.box, 0.45),
                                              kernel, cloud.habitat)};
    return voxels;
  }
  // Mean numbers from n molecules in voxel 14, by the Taylor series of the generator's exponential.
  static std::vector<double> law(double n, double t) {
    const auto graph = voxels(true).graphs[0];
    std::vector<double> sum(36, 0.0), term(36, 0.0);
    term[14] = n;
    for (int order = 1; order < 400; ++order) {
      std::vector<double> next(36, 0.0);
      for (std::size_t i = 0; i < 36; ++i) {
        sum[i] += term[i];
        for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p) {
          next[graph.target[p]] += term[i] * graph.coupling[p] * t / order;
          next[i] -= term[i] * graph.coupling[p] * t / order;
        }
      }
      term = next;
    }
    return sum;
  }
};

// Few molecules are moved one by one, many by rows that are listed after all; one step or three.
TEST_P(UnlistedSampling, IsMultinomial) {
  constexpr double t = 0.02;
  for (const auto& [molecules, runs, steps] : {std::tuple{30, 1500, 1}, {30, 1500, 3}, {100000, 1, 1}}) {
    Trial trial(GetParam(), scene(), voxels(false));
    std::vector<double> observed(36, 0.0);
    for (int k = 0; k < runs; ++k) {
      trial.key.realisation = static_cast<std::uint32_t>(k);
      trial.state.count.assign(36, 0);
      trial.state.count[14] = molecules;
      trial.t = 0;
      trial.begin();
      trial.run(t, t / steps);
      for (std::size_t i = 0; i < 36; ++i) observed[i] += static_cast<double>(trial.state.count[i]);
    }
    EXPECT_GT(chi_square(observed, law(double(molecules) * runs, t)), false_alarm) << molecules << " " << steps;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, UnlistedSampling,
                         testing::Values(scene::Sampler::composition_rejection, scene::Sampler::split,
                                         scene::Sampler::tau_leaping),
                         method_name);

}  // namespace
}  // namespace shmoo::rdme
