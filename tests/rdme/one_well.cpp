// The exact method of a single well, with few reactions and with many: laws of whole distributions over realisations.
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

constexpr int realisations = 2000;

struct OneWellTrial {
  Network network;
  Voxels voxels;
  State state;
  std::unique_ptr<Sampler> sampler;

  OneWellTrial(const scene::Scene& scene, double volume)
      : network(scene), voxels(lattice({1, 1, 1}, false, volume, network.species())) {
    voxels.graph_of_species.assign(network.species(), -1);
    state = empty_state(network, 1);
    sampler = make_well_sampler(scene::Sampler::composition_rejection, network);
    sampler->bind(voxels, state);
  }

  // Numbers at the end of each realisation, by species.
  std::vector<Sample> run(const std::vector<std::int64_t>& start, double until, double dt) {
    std::vector<Sample> ends(network.species());
    for (std::uint32_t k = 0; k < realisations; ++k) {
      state.count = start;
      open_ledger(state, network);
      sampler->amounts_changed();
      for (std::uint64_t step = 0; double(step) * dt < until * (1 - 1e-12); ++step)
        sampler->advance(double(step) * dt, dt, Process::both, {7, k}, step);
      EXPECT_EQ(imbalance(state, network), "");
      for (std::size_t s = 0; s < ends.size(); ++s) ends[s].add(double(state.count[s]));
    }
    return ends;
  }
};

// Each species comes and goes by itself: Poisson with mean (birth/death)(1 - exp(-death t)).
void expect_births_and_deaths(int species) {
  scene::Scene scene = water();
  for (int s = 0; s < species; ++s) {
    const int x = add_species(scene, "X" + std::to_string(s));
    add_reaction(scene, "birth", {}, {{x, 1}}, 3.0 + s);
    add_reaction(scene, "death", {{x, 1}}, {}, 0.5);
  }
  OneWellTrial trial(scene, 2.0);
  const auto ends = trial.run(std::vector<std::int64_t>(std::size_t(species), 0), 3.0, 0.75);
  for (int s = 0; s < species; ++s) {
    const double mean = 2.0 * (3.0 + s) / 0.5 * (1 - std::exp(-1.5));
    EXPECT_GT(chi_square(ends[std::size_t(s)], poisson_law(mean, int(mean + 10 * std::sqrt(mean) + 10))), false_alarm);
  }
}

TEST(OneWell, FewReactionsHaveTheirLaw) { expect_births_and_deaths(2); }
TEST(OneWell, ManyReactionsHaveTheirLaw) { expect_births_and_deaths(12); }

// Rates over twelve decades among twenty reactions: A <-> B fast, others slow; what is slow is not lost.
TEST(OneWell, SlowReactionsAmongFastOnesHaveTheirLaw) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A"), b = add_species(scene, "B");
  add_reaction(scene, "there", {{a, 1}}, {{b, 1}}, 2e2);
  add_reaction(scene, "back", {{b, 1}}, {{a, 1}}, 2e2);
  for (int s = 0; s < 18; ++s)
    add_reaction(scene, "birth", {}, {{add_species(scene, "X" + std::to_string(s)), 1}}, std::pow(10.0, 0.5 - 0.5 * s));
  OneWellTrial trial(scene, 1.0);
  std::vector<std::int64_t> start(20, 0);
  start[std::size_t(a)] = 20;
  const auto ends = trial.run(start, 1.0, 1.0);
  expect_mean(ends[std::size_t(a)], 10.0);
  expect_variance(ends[std::size_t(a)], 5.0);
  for (int s = 0; s < 18; ++s) {
    const double mean = std::pow(10.0, 0.5 - 0.5 * s);
    EXPECT_NEAR(ends[std::size_t(2 + s)].sum, realisations * mean, 5 * std::sqrt(realisations * mean) + 1);
  }
}

TEST(OneWell, PairsFollowTheFallingFactorial) {  // 2 A -> 0 from an odd number leaves one
  scene::Scene scene = water();
  const int a = add_species(scene, "A");
  add_reaction(scene, "pair", {{a, 2}}, {}, 1.0);
  OneWellTrial trial(scene, 1.0);
  const auto ends = trial.run({11}, 50.0, 50.0);
  EXPECT_EQ(ends[std::size_t(a)].mean(), 1.0);
  EXPECT_EQ(ends[std::size_t(a)].variance(), 0.0);
}

}  // namespace
}  // namespace shmoo::rdme
