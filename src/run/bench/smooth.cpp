// Methods of smooth amounts: Langevin by the events that its noise stands for, and the deterministic solver by how much
// it carries to equilibrium.
#include <fmt/format.h>

#include <cmath>

#include "base/clock.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/langevin.hpp"
#include "run/bench/lattice_problem.hpp"
#include "run/bench/workload.hpp"

namespace shmoo::run::bench {
namespace {

constexpr double most_deviations = 5.0, most_error = 1e-3;

scene::Scene treated(scene::Scene scene, scene::SpeciesMethod method) {
  for (auto& species : scene.species) species.method = method;
  return scene;
}

// From Poisson numbers.
void fill_smooth(rdme::State& state, const rdme::Network& network, double mean) {
  fill_poisson(state, mean);
  state.amount.assign(state.count.begin(), state.count.end());
  rdme::open_ledger(state, network);
}

// 10^5 molecules in one well: M at equilibrium and its standard deviation (detailed balance, as of the dimer bench).
Measurement langevin_dimers(double seconds) {
  constexpr double back = 1.0, K = 0.01, dt = 0.2;
  const rdme::Network network(treated(dimer_scene(0.01, back), scene::SpeciesMethod::langevin));
  const auto voxels = lattice({1, 1, 1}, network.species());
  auto state = rdme::empty_state(network, 1);
  fill_smooth(state, network, 1e5 / 3.0);
  const double before = allocated_bytes();
  rdme::LangevinSolver solver(network);
  solver.bind(voxels, state);
  std::uint64_t step = 0;
  for (; step < 50; ++step) solver.advance(0, dt, rdme::Process::both, {1, 0}, step);
  Measurement measurement;
  measurement.bytes_per_voxel = allocated_bytes() - before;
  const double start = base::cpu_seconds(), first = double(step), total = state.amount[1] + 2.0 * state.amount[0];
  do {
    solver.advance(0, dt, rdme::Process::both, {1, 0}, step++);
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  const double m = (std::sqrt(1.0 + 8.0 * K * total) - 1.0) / (4.0 * K), d = 0.5 * (total - m);
  measurement.rate = 2.0 * back * d * dt * (double(step) - first) / measurement.cpu_seconds;
  const double off = (state.amount[1] - m) / std::sqrt(4.0 * m * d / (m + 4.0 * d));
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && std::abs(off) < most_deviations;
  measurement.check = lost.empty() ? fmt::format("2 M <-> D in equilibrium: {:+.2f} standard deviations", off) : lost;
  return measurement;
}

// A + B <-> C from scattered numbers for a second, by which reactions are done: 0.9 A B = 9 C in each voxel but for
// what gradients still carry.
Measurement smooth_binding(std::uint32_t n, double seconds) {
  const rdme::Network network(treated(binding_scene(), scene::SpeciesMethod::deterministic));
  const auto voxels = lattice({n, n, n}, network.species());
  auto state = rdme::empty_state(network, voxels.size());
  const double before = allocated_bytes();
  rdme::DeterministicSolver solver(network, 1e-6);
  Measurement measurement;
  int runs = 0;
  const double start = base::cpu_seconds();
  do {
    fill_smooth(state, network, 10.0);
    solver.bind(voxels, state);
    solver.advance(0, 1.0, rdme::Process::both);
    ++runs;
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size());
  measurement.rate = double(voxels.size()) * runs / measurement.cpu_seconds;
  double forward = 0.0, backward = 0.0;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    forward += 0.9 * state.amount[3 * i] * state.amount[3 * i + 1];
    backward += 9.0 * state.amount[3 * i + 2];
  }
  const double off = forward / backward - 1.0;
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && std::abs(off) < most_error;
  measurement.check = lost.empty() ? fmt::format("A + B <-> C in equilibrium: to {:.1e}", std::abs(off)) : lost;
  return measurement;
}

}  // namespace

std::vector<Workload> smooth_workloads() {
  std::vector<Workload> all;
  all.push_back({"dimer", "langevin", "events per CPU second", langevin_dimers});
  for (const std::uint32_t n : {10u, 30u})
    all.push_back({fmt::format("RD-{}", n), "ode", "voxels a second each, per CPU s",
                   [n](double seconds) { return smooth_binding(n, seconds); }});
  return all;
}

}  // namespace shmoo::run::bench
