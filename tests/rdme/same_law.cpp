// A case that has no simple exact law, by every method: A and B meet between two reservoirs in unequal voxels with a
// flow and a reaction that runs in one material only. Numbers of all methods must be samples of one law.
#include "trial.hpp"

namespace shmoo::rdme {
namespace {

struct Outcome {
  Sample a, b, c;
};

Outcome outcomes(scene::Sampler method, double step) {
  scene::Scene scene = water();
  scene.materials.resize(2);
  const int a = add_species(scene, "A", 1.0), b = add_species(scene, "B", 0.5), c = add_species(scene, "C", 0.0);
  for (scene::Species& one : scene.species) one.homes = {0, 1};
  add_reaction(scene, "annihilation", {{a, 1}, {b, 1}}, {}, 0.3);
  add_reaction(scene, "dimerisation", {{a, 2}}, {{c, 1}}, 0.5);
  add_reaction(scene, "break-up", {{c, 1}}, {{a, 2}}, 0, "0.4*C/(1 + C)");
  scene.reactions[1].materials = {1};
  Trial trial(method, scene, lattice({6, 1, 1}, false, 1.0, 3));
  trial.voxels.volume = {1, 2, 1, 0.5, 1, 1};
  trial.voxels.material = {0, 0, 1, 1, 0, 0};
  JumpGraph& graph = trial.voxels.graphs[0];
  for (std::uint32_t i = 0; i < 6; ++i) {
    for (std::uint64_t p = graph.first[i]; p < graph.first[i + 1]; ++p) {
      graph.coupling[p] = 1.0 / trial.voxels.volume[i];
      graph.flow.push_back(graph.target[p] > i ? 0.8 : -0.8);
    }
  }
  trial.voxels.exchanges = {{0, 0, 2.0, 16.0}, {5, 1, 2.0, 16.0}};
  Outcome outcome;
  for (std::uint32_t k = 0; k < 1500; ++k) {
    trial.key = {9, k};
    std::ranges::fill(trial.state.count, 0);
    trial.state.jump_events = trial.state.reaction_events = 0;
    trial.t = 0;
    trial.begin();
    trial.run(2.0, step);
    outcome.a.add(static_cast<double>(total_count(trial.state, a)));
    outcome.b.add(static_cast<double>(total_count(trial.state, b)));
    outcome.c.add(static_cast<double>(total_count(trial.state, c)));
  }
  return outcome;
}

// Two-sample chi-square; bins are joined until they hold at least ten.
double same(const Sample& x, const Sample& y) {
  double largest = 0;
  for (const Sample* one : {&x, &y}) {
    for (double value : one->values) largest = std::max(largest, value);
  }
  std::vector<double> nx(static_cast<std::size_t>(largest) + 1), ny(nx.size());
  for (double value : x.values) ++nx[static_cast<std::size_t>(value)];
  for (double value : y.values) ++ny[static_cast<std::size_t>(value)];
  double misfit = 0, in_x = 0, in_y = 0;
  int bins = 0;
  for (std::size_t k = 0; k < nx.size(); ++k) {
    in_x += nx[k];
    in_y += ny[k];
    if (in_x + in_y < 10 && k + 1 < nx.size()) continue;
    if (in_x + in_y > 0) misfit += (in_x - in_y) * (in_x - in_y) / (in_x + in_y), ++bins;
    in_x = in_y = 0;
  }
  return gsl_cdf_chisq_Q(misfit, bins - 1);
}

TEST(SameLaw, ByAllMethods) {
  const Outcome reference = outcomes(scene::Sampler::direct, 2.0);
  EXPECT_GT(reference.c.mean(), 0.3);
  const Outcome exact = outcomes(scene::Sampler::composition_rejection, 2.0);
  const Outcome split = outcomes(scene::Sampler::split, 0.05);
  const Outcome leaps = outcomes(scene::Sampler::tau_leaping, 0.05);
  for (const Outcome* one : {&exact, &split, &leaps}) {
    EXPECT_GT(same(reference.a, one->a), false_alarm);
    EXPECT_GT(same(reference.b, one->b), false_alarm);
    EXPECT_GT(same(reference.c, one->c), false_alarm);
  }
}

}  // namespace
}  // namespace shmoo::rdme
