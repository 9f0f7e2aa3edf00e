// Reactions alone, every method against exact laws. Voxels without jumps are independent copies of one well mixed
// volume.
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

class WellMixed : public testing::TestWithParam<scene::Sampler> {};

TEST_P(WellMixed, BirthAndDeathIsPoissonFromNothing) {
  scene::Scene scene = water();
  const int x = add_species(scene, "X");
  add_reaction(scene, "birth", {}, {{x, 1}}, 5.0);
  add_reaction(scene, "death", {{x, 1}}, {}, 1.0);
  Trial trial(GetParam(), scene, lattice({2000, 1, 1}, false, 2.0, 1));
  trial.voxels.graph_of_species = {-1};
  trial.begin();
  trial.run(3.0, 1.0);
  const double mean = 10.0 * (1 - std::exp(-3.0));
  EXPECT_GT(chi_square(trial.sample(x), poisson_law(mean, 40)), false_alarm);
}

TEST_P(WellMixed, BirthAndDeathMeetsTheTable) {
  const auto table = read_table("birth_death.csv");
  scene::Scene scene = water();
  const int x = add_species(scene, "X");
  add_reaction(scene, "birth", {}, {{x, 1}}, 10.0);
  add_reaction(scene, "death", {{x, 1}}, {}, 0.1);
  Trial trial(GetParam(), scene, lattice({1000, 1, 1}, false, 1.0, 1));
  trial.voxels.graph_of_species = {-1};
  fill(trial.state, x, 50);
  trial.begin();
  for (std::size_t row : {1U, 3U}) {
    trial.run(table.at("t")[row], 10.0);
    expect_mean(trial.sample(x), table.at("mean_n0_50")[row]);
    expect_variance(trial.sample(x), table.at("var_n0_50")[row]);
  }
}

// The tables count per unordered pair, a = c n (n - 1)/2; the network's constant per ordered pair is half of it.
TEST_P(WellMixed, AnnihilationMeetsTheTable) {
  const auto table = read_table("apa_annihilation_wellmixed.csv");
  scene::Scene scene = water();
  const int a = add_species(scene, "A");
  add_reaction(scene, "annihilation", {{a, 2}}, {}, 0.02 / 2 * 3.0);
  Trial trial(GetParam(), scene, lattice({1500, 1, 1}, false, 3.0, 1));
  trial.voxels.graph_of_species = {-1};
  fill(trial.state, a, 100);
  trial.begin();
  for (std::size_t row : {2U, 4U}) {
    trial.run(table.at("t")[row], 0.3);
    expect_mean(trial.sample(a), table.at("mean")[row]);
    expect_variance(trial.sample(a), table.at("variance")[row]);
  }
}

TEST_P(WellMixed, AnnihilationFromAnOddNumberLeavesOne) {
  const auto table = read_table("apa_annihilation_small_odd.csv");
  scene::Scene scene = water();
  const int a = add_species(scene, "A");
  add_reaction(scene, "annihilation", {{a, 2}}, {}, 0.1 / 2);
  Trial trial(GetParam(), scene, lattice({2000, 1, 1}, false, 1.0, 1));
  trial.voxels.graph_of_species = {-1};
  fill(trial.state, a, 11);
  trial.begin();
  trial.run(5.0, 5.0);
  expect_mean(trial.sample(a), table.at("mean")[5]);
  expect_variance(trial.sample(a), table.at("variance")[5]);
  trial.run(2000.0, 1995.0);
  EXPECT_EQ(trial.sample(a).mean(), 1.0);
}

TEST_P(WellMixed, BindingMeetsTransientAndStationaryTables) {
  const auto transient = read_table("abc_reversible_transient.csv");
  const auto law = read_table("abc_reversible_pmf_A20_B15.csv").at("P");
  scene::Scene scene = water();
  const int a = add_species(scene, "A"), b = add_species(scene, "B"), c = add_species(scene, "C");
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 0.01 * 0.25);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 0.1);
  Trial trial(GetParam(), scene, lattice({1500, 1, 1}, false, 0.25, 3));
  trial.voxels.graph_of_species = {-1, -1, -1};
  fill(trial.state, a, 20);
  fill(trial.state, b, 15);
  trial.begin();
  trial.run(2.0, 1.0);
  expect_mean(trial.sample(c), transient.at("mean_C")[3]);
  expect_variance(trial.sample(c), transient.at("var_C")[3]);
  trial.run(50.0, 24.0);
  EXPECT_GT(chi_square(trial.sample(c), law), false_alarm);
}

// An expression that says the same as mass action gives the same law; the falling factorial is its own business.
TEST_P(WellMixed, ExpressionsActAsRateLaws) {
  scene::Scene scene = water();
  scene.parameters["k"] = 10.0;
  const int x = add_species(scene, "X");
  add_reaction(scene, "birth", {}, {{x, 1}}, 0, "k/2 * (1 + 0*x)");
  add_reaction(scene, "death", {{x, 1}}, {}, 0, "0.1 * X * (1 + t)/(1 + t)");
  Trial trial(GetParam(), scene, lattice({1000, 1, 1}, false, 2.0, 1));
  trial.voxels.graph_of_species = {-1};
  fill(trial.state, x, 50);
  trial.begin();
  trial.run(5.0, 2.5);
  const auto table = read_table("birth_death.csv");
  expect_mean(trial.sample(x), table.at("mean_n0_50")[3]);
  expect_variance(trial.sample(x), table.at("var_n0_50")[3]);
}

INSTANTIATE_TEST_SUITE_P(Method, WellMixed, every_method, method_name);

}  // namespace
}  // namespace shmoo::rdme
