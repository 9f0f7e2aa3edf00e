#include "coupling/activity.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/initial.hpp"
#include "rdme/lump.hpp"

namespace shmoo::coupling {
namespace {

constexpr std::size_t most_voxels = 200;
constexpr double tolerance = 1e-3;
constexpr int parts = 200;  // of the run

scene::Scene smoothed(scene::Scene scene) {
  for (auto& species : scene.species) species.method = scene::SpeciesMethod::deterministic;
  return scene;
}

// Jumps of a species make the propensities anew that read it: what a jump costs then, in jumps that nothing reads.
double weight(const rdme::Network& network, int species) {
  constexpr double law = 0.25, formula = 4.0;  // measured
  double weight = 1.0;
  for (const auto& reaction : network.reactions())
    if (std::ranges::binary_search(reaction.reads, species)) weight += reaction.expression.empty() ? law : formula;
  return weight;
}

// Rate [1/s] at which a molecule of each species leaves its voxel, the mean over its habitat, times the jump's weight.
std::vector<double> leaving_rates(const rdme::Network& network, const rdme::Voxels& voxels) {
  std::vector<double> rates;
  for (std::size_t s = 0; s < network.species(); ++s) {
    const int g = voxels.graph_of_species[s];
    double sum = 0.0, volume = 0.0;
    for (std::size_t i = 0; g >= 0 && i < voxels.size(); ++i) {
      const auto& graph = voxels.graphs[std::size_t(g)];
      if (graph.first[i] == graph.first[i + 1]) continue;
      volume += voxels.volume[i];
      for (auto p = graph.first[i]; p < graph.first[i + 1]; ++p)
        sum += voxels.volume[i] * rdme::jump_rate(graph, p, network.diffusivity(int(s)), voxels.volume[i]);
    }
    rates.push_back(volume > 0.0 ? weight(network, int(s)) * sum / volume : 0.0);
  }
  return rates;
}

rdme::State lumped(const rdme::State& fine, const rdme::Lumps& lumps, const rdme::Network& network) {
  auto state = rdme::empty_state(network, lumps.voxels.size());
  for (std::size_t i = 0; i < lumps.of.size(); ++i)
    for (std::size_t s = 0; s < network.species(); ++s)
      state.amount[lumps.of[i] * network.species() + s] += fine.amount[i * network.species() + s];
  rdme::open_ledger(state, network);
  return state;
}

double turned(const rdme::State& state) {
  double sum = 0.0;
  for (const auto& account : state.ledger.amounts) sum += account.created + account.destroyed;
  return 0.5 * sum;
}

double jumping(const rdme::State& state, const std::vector<double>& leaving) {
  double rate = 0.0;
  for (std::size_t s = 0; s < leaving.size(); ++s)
    if (leaving[s] > 0.0) rate += leaving[s] * rdme::total_amount(state, int(s));
  return rate;
}

}  // namespace

std::vector<double> foretell_activity(const scene::Scene& scene, const rdme::Voxels& voxels,
                                      const std::array<double, 3>& period, const std::function<bool()>& stop) {
  const auto smooth = smoothed(scene);
  const rdme::Network network(smooth);
  const auto leaving = leaving_rates(network, voxels);
  const auto lumps = rdme::lump(voxels, most_voxels, period);
  auto state = lumped(rdme::initial_state(smooth, network, voxels, {}), lumps, network);
  rdme::DeterministicSolver solver(network, tolerance);
  solver.bind(lumps.voxels, state);
  std::vector<double> activity;
  const double dt = scene.run.until / parts;
  double jumps = jumping(state, leaving);
  try {
    for (int k = 0; k < parts && !stop(); ++k) {
      const double before = turned(state), at_begin = jumps;
      solver.advance(k * dt, dt, rdme::Process::both);
      jumps = jumping(state, leaving);
      activity.push_back(0.5 * (at_begin + jumps) + (turned(state) - before) / dt);
    }
  } catch (const base::RunError&) {  // only a forecast: what came so far will do
  }
  if (!activity.empty()) activity.resize(parts, activity.back());
  return activity;
}

}  // namespace shmoo::coupling
