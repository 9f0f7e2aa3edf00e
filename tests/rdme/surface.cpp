// Reactions between voxels of two materials, by the exact methods.
#include "rdme/deterministic.hpp"
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

class Surfaces : public testing::TestWithParam<scene::Sampler> {};

// A wall voxel (0) that touches two of three voxels of water, unequally.
scene::Scene wall_and_water() {
  scene::Scene scene = water();
  scene.materials.resize(2);
  scene.materials[1].name = "wall";
  return scene;
}

Voxels wall_beside_water(std::size_t species) {
  Voxels voxels = lattice({4, 1, 1}, false, 1.0, species);
  voxels.volume = {0.5, 1.0, 2.0, 1.0};
  voxels.material = {1, 0, 0, 0};
  JumpGraph graph;  // between 1, 2 and 3: V_i c_ij = 1
  graph.first = {0, 0, 1, 3, 4};
  graph.target = {2, 1, 3, 2};
  graph.coupling = {1.0, 0.5, 0.5, 1.0};
  voxels.graphs = {graph};
  voxels.surfaces = {{{1, 0}, {0, 2, 2, 2, 2}, {1, 2}, {3.0, 1.0}, {0.75, 0.25}}};
  return voxels;
}

void add_on_surface(scene::Scene& scene, const std::string& name, std::vector<scene::Term> reactants,
                    std::vector<scene::Term> products, double k) {
  add_reaction(scene, name, std::move(reactants), std::move(products), k);
  scene.reactions.back().surface = {1, 0};
}

// Binding and its reverse are in detailed balance in each pair, so the number bound has the law of one well that holds
// all the water (product of Poisson laws, given the totals).
TEST_P(Surfaces, ReversibleBindingHasItsProductLaw) {
  scene::Scene scene = wall_and_water();
  const int l = add_species(scene, "L", 1.0), r = add_species(scene, "R"), b = add_species(scene, "B");
  scene.species[r].homes = scene.species[b].homes = {1};
  add_on_surface(scene, "binding", {{l, 1}, {r, 1}}, {{b, 1}}, 0.8);
  add_on_surface(scene, "unbinding", {{b, 1}}, {{l, 1}, {r, 1}}, 1.5);
  std::vector<double> law{1.0};
  double sum = 1.0;
  for (int c = 0; c < 9; ++c) {
    law.push_back(law.back() * 0.8 / 4.0 * (12.0 - c) * (9.0 - c) / (1.5 * (c + 1.0)));
    sum += law.back();
  }
  for (double& p : law) p /= sum;
  Sample bound, mean_water;
  for (std::uint32_t k = 0; k < 4000; ++k) {
    Trial trial(GetParam(), scene, wall_beside_water(3));
    trial.voxels.graph_of_species = {0, -1, -1};
    trial.key = {3, k};
    trial.state.count[3 * 3 + l] = 12;
    trial.state.count[r] = 9;
    trial.begin();
    trial.run(12.0, 6.0);
    bound.add(double(trial.state.count[b]));
    EXPECT_EQ(total_count(trial.state, l) + total_count(trial.state, b), 12);
    EXPECT_EQ(trial.state.count[r] + trial.state.count[b], 9);
  }
  EXPECT_GT(chi_square(bound, law), 1e-6);
}

// First-order networks: the mean of every exact sampler is the deterministic solution.
TEST_P(Surfaces, MeansOfTransfersAreDeterministic) {
  Sample sampled;
  double expected = 0;
  for (const auto method : {scene::SpeciesMethod::deterministic, scene::SpeciesMethod::stochastic}) {
    scene::Scene scene = wall_and_water();
    const int l = add_species(scene, "L", 1.0, method), w = add_species(scene, "W", 0.0, method);
    scene.species[w].homes = {1};
    add_on_surface(scene, "in", {{l, 1}}, {{w, 1}}, 0.3);
    add_on_surface(scene, "out", {{w, 1}}, {{l, 2}}, 0.4);
    const Network network(scene);
    EXPECT_TRUE(network.reactions()[0].per_area);
    EXPECT_FALSE(network.reactions()[1].per_area);
    if (method == scene::SpeciesMethod::deterministic) {
      Voxels voxels = wall_beside_water(2);
      voxels.graph_of_species = {0, -1};
      State state = empty_state(network, 4);
      state.amount[2 * 2 + l] = 30;
      open_ledger(state, network);
      DeterministicSolver solver(network, 1e-9);
      solver.bind(voxels, state);
      solver.advance(0.0, 1.5, Process::both);
      expected = state.amount[w];
      EXPECT_EQ(imbalance(state, network), "");
      continue;
    }
    for (std::uint32_t k = 0; k < 3000; ++k) {
      Trial trial(GetParam(), scene, wall_beside_water(2));
      trial.voxels.graph_of_species = {0, -1};
      trial.key = {5, k};
      trial.state.count[2 * 2 + l] = 30;
      trial.begin();
      trial.run(1.5, 1.5);
      sampled.add(double(trial.state.count[w]));
    }
  }
  EXPECT_GT(expected, 3.0);
  expect_mean(sampled, expected);
}

INSTANTIATE_TEST_SUITE_P(Method, Surfaces,
                         testing::Values(scene::Sampler::direct, scene::Sampler::composition_rejection), method_name);

TEST(Surface, CannotBeSplit) {
  scene::Scene scene = wall_and_water();
  const int l = add_species(scene, "L"), w = add_species(scene, "W");
  scene.species[w].homes = {1};
  add_on_surface(scene, "in", {{l, 1}}, {{w, 1}}, 0.3);
  EXPECT_THROW(make_sampler(scene::Sampler::split, Network(scene)), base::InputError);
}

}  // namespace
}  // namespace shmoo::rdme
