#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <set>

#include "base/clock.hpp"
#include "rdme/jump_table.hpp"
#include "rdme/sampler.hpp"
#include "run/bench/lattice_problem.hpp"
#include "run/bench/next_subvolume.hpp"
#include "run/bench/problem.hpp"
#include "run/bench/workload.hpp"

namespace shmoo::run::bench {
namespace {

constexpr double most_deviations = 5.0;

std::uint64_t events_of(const rdme::State& state) { return state.reaction_events + state.jump_events; }

void judge(const Problem& problem, const rdme::Network& network, const rdme::State& state, Measurement& measurement) {
  const double off = problem.deviations(counts_of(state));
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && std::abs(off) < most_deviations;
  measurement.check = lost.empty() ? fmt::format("{}: {:+.2f} standard deviations", problem.law, off) : lost;
}

double row_bytes(const rdme::JumpTables* tables) {
  if (!tables) return 0.0;  // the direct method has none
  const std::set<std::shared_ptr<const rdme::JumpTable>> different(tables->of_species.begin(),
                                                                   tables->of_species.end());
  double bytes = 0.0;
  for (const auto& table : different) bytes += table ? double(table->bytes()) : 0.0;
  return bytes;
}

Measurement with_sampler(const Problem& problem, scene::Sampler method, double dt, double seconds) {
  const rdme::Network network(problem.scene);
  const auto voxels = lattice(problem.cells, network.species());
  auto state = rdme::empty_state(network, voxels.size());
  fill_poisson(state, problem.mean);
  rdme::open_ledger(state, network);
  const double before = allocated_bytes();
  auto sampler = voxels.size() == 1 ? rdme::make_well_sampler(method, network) : rdme::make_sampler(method, network);
  const auto tables = sampler->prepare(voxels);
  sampler->bind(voxels, state, tables);
  std::uint64_t step = 0;
  sampler->advance(0, dt, rdme::Process::both, {1, 0}, step++);
  Measurement measurement;
  measurement.row_bytes_per_voxel = row_bytes(tables.get()) / double(voxels.size());
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size()) - measurement.row_bytes_per_voxel;
  const auto done = events_of(state);
  const double start = base::cpu_seconds();
  do {
    sampler->advance(0, dt, rdme::Process::both, {1, 0}, step++);
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate = double(events_of(state) - done) / measurement.cpu_seconds;
  judge(problem, network, state, measurement);
  return measurement;
}

Measurement with_heap(const Problem& problem, double seconds) {
  const rdme::Network network(problem.scene);
  const auto voxels = lattice(problem.cells, network.species());
  auto state = rdme::empty_state(network, voxels.size());
  fill_poisson(state, problem.mean);
  const double before = allocated_bytes();
  NextSubvolume heap(network, voxels, state);
  constexpr std::uint64_t portion = 100000;
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size());
  std::uint64_t done = 0;
  const double start = base::cpu_seconds();
  do {
    heap.events(portion);
    done += portion;
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate = double(done) / measurement.cpu_seconds;
  const double off = problem.deviations(counts_of(state));
  measurement.right = std::abs(off) < most_deviations;
  measurement.check = fmt::format("{}: {:+.2f} standard deviations", problem.law, off);
  return measurement;
}

// About this many events a call of advance(), so that exact methods are timed in portions.
double portion(const Problem& problem) { return 2e5 / problem.events_per_second; }

void add(std::vector<Workload>& all, const Problem& problem, const std::string& method, scene::Sampler sampler,
         double dt) {
  all.push_back({problem.name, method, "events per CPU second",
                 [=](double seconds) { return with_sampler(problem, sampler, dt, seconds); }});
}

void add_heap(std::vector<Workload>& all, const Problem& problem) {
  all.push_back({problem.name, "exact-next-subvolume-heap", "events per CPU second",
                 [=](double seconds) { return with_heap(problem, seconds); }});
}

void add_exact(std::vector<Workload>& all, const Problem& problem) {
  add(all, problem, "exact-composition-rejection", scene::Sampler::composition_rejection, portion(problem));
}

void add_split(std::vector<Workload>& all, const Problem& problem, std::initializer_list<double> jumps) {
  for (const double each : jumps)
    add(all, problem, fmt::format("split-{:g}-jumps", each), scene::Sampler::split, each / 6.0);
}

std::vector<Workload> of_diffusion(std::uint32_t n) {
  std::vector<Workload> all;
  const Problem problem = diffusion_problem(n);
  add_heap(all, problem);
  if (n <= 10) add(all, problem, "direct", scene::Sampler::direct, 0.1 * portion(problem));
  add_exact(all, problem);
  add_split(all, problem, {0.6, 3.0});
  add(all, problem, "tau-3-jumps", scene::Sampler::tau_leaping, 0.5);
  return all;
}

std::vector<Workload> of_binding(std::uint32_t n) {
  std::vector<Workload> all;
  const Problem problem = binding_problem(n);
  add_heap(all, problem);
  add_exact(all, problem);
  add_split(all, problem, {0.06, 0.6, 3.0});
  add(all, problem, "tau-0.6-jumps", scene::Sampler::tau_leaping, 0.1);
  return all;
}

// One voxel, where a leap may be as long as it likes.
std::vector<Workload> of_well(const Problem& problem) {
  std::vector<Workload> all;
  add(all, problem, "direct", scene::Sampler::direct, portion(problem));
  add_exact(all, problem);
  add(all, problem, "tau", scene::Sampler::tau_leaping, 10.0);
  return all;
}

}  // namespace

std::vector<Workload> chemistry_workloads() {
  std::vector<Workload> all;
  const auto take = [&all](std::vector<Workload> some) { std::ranges::move(some, std::back_inserter(all)); };
  for (const std::uint32_t n : {10u, 30u, 60u, 100u}) take(of_diffusion(n));
  for (const std::uint32_t n : {10u, 30u, 60u}) take(of_binding(n));
  for (const int n : {10, 100}) take(of_well(ring_problem(n)));
  take(of_well(dimer_problem()));
  return all;
}

std::vector<Workload> lattice_workloads(const std::string& name) {
  unsigned n = 0;
  char rest = 0;
  const bool diffusion = std::sscanf(name.c_str(), "D3-%3u%c", &n, &rest) == 1;
  const bool binding = !diffusion && std::sscanf(name.c_str(), "RD-%3u%c", &n, &rest) == 1;
  if (n < 3 || n > 200 || !(diffusion || binding)) return {};
  return diffusion ? of_diffusion(n) : of_binding(n);
}

}  // namespace shmoo::run::bench
