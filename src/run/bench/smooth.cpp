// Methods of smooth amounts: Langevin by the events that its noise stands for, and the deterministic solver by how much
// of space and time it carries along.
#include <fmt/format.h>

#include <cmath>

#include "base/clock.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/langevin.hpp"
#include "run/bench/lattice_problem.hpp"
#include "run/bench/problem.hpp"
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

// At equilibrium, with so many molecules that amounts may be smooth.
Measurement with_langevin(const Problem& problem, double mean, double dt, double seconds) {
  const rdme::Network network(treated(problem.scene, scene::SpeciesMethod::langevin));
  const auto voxels = lattice(problem.cells, network.species());
  auto state = rdme::empty_state(network, voxels.size());
  fill_smooth(state, network, mean);
  const double before = allocated_bytes();
  rdme::LangevinSolver solver(network);
  solver.bind(voxels, state);
  std::uint64_t step = 0;
  solver.advance(0, dt, rdme::Process::both, {1, 0}, step++);
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size());
  const double start = base::cpu_seconds(), first = double(step);
  do {
    solver.advance(0, dt, rdme::Process::both, {1, 0}, step++);
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate =
      problem.events_per_second * mean / problem.mean * dt * (double(step) - first) / measurement.cpu_seconds;
  const double off = problem.deviations(amounts_of(state));
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && std::abs(off) < most_deviations;
  measurement.check = lost.empty() ? fmt::format("{}: {:+.2f} standard deviations", problem.law, off) : lost;
  return measurement;
}

Measurement with_solver(const Problem& problem, double seconds) {
  const rdme::Network network(treated(problem.scene, scene::SpeciesMethod::deterministic));
  const auto voxels = lattice(problem.cells, network.species());
  auto state = rdme::empty_state(network, voxels.size());
  const double before = allocated_bytes();
  rdme::DeterministicSolver solver(network, 1e-6);
  Measurement measurement;
  int runs = 0;
  const double start = base::cpu_seconds();
  do {
    fill_smooth(state, network, problem.mean);
    Numbers numbers = amounts_of(state);
    problem.start(numbers);
    state.amount = numbers.n;
    rdme::open_ledger(state, network);
    solver.bind(voxels, state);
    solver.advance(0, problem.until, rdme::Process::both);
    ++runs;
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size());
  measurement.rate = double(voxels.size()) * problem.until * runs / measurement.cpu_seconds;
  const double off = problem.error(amounts_of(state));
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && std::abs(off) < most_error;
  measurement.check = lost.empty() ? fmt::format("{}: to {:.1e}", problem.smooth_law, std::abs(off)) : lost;
  return measurement;
}

}  // namespace

std::vector<Workload> smooth_workloads() {
  std::vector<Workload> all;
  const auto langevin = [&](const Problem& problem, double mean, double dt) {
    all.push_back({problem.name, "langevin", "events per CPU second",
                   [=](double seconds) { return with_langevin(problem, mean, dt, seconds); }});
  };
  const auto ode = [&](const Problem& problem) {
    all.push_back({problem.name, "ode", "voxels a second each, per CPU s",
                   [=](double seconds) { return with_solver(problem, seconds); }});
  };
  for (const std::uint32_t n : {10u, 30u, 60u, 100u}) {
    langevin(diffusion_problem(n), 1000.0, 0.01);
    ode(diffusion_problem(n));
  }
  for (const std::uint32_t n : {10u, 30u, 60u}) {
    langevin(binding_problem(n, 1000.0), 1000.0, 0.01);
    ode(binding_problem(n));
  }
  for (const int n : {10, 100}) {
    langevin(ring_problem(n), 1000.0, 0.2);
    ode(ring_problem(n));
  }
  langevin(dimer_problem(), 1e5 / 3.0, 0.2);
  ode(dimer_problem());
  return all;
}

}  // namespace shmoo::run::bench
