#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/clock.hpp"
#include "rdme/jump_table.hpp"
#include "rdme/sampler.hpp"
#include "run/bench/lattice_problem.hpp"
#include "run/bench/next_subvolume.hpp"
#include "run/bench/workload.hpp"

namespace shmoo::run::bench {
namespace {

constexpr double most_deviations = 5.0;

// A network on a lattice, ready to run, and how its law is checked.
struct Problem {
  scene::Scene scene;
  std::array<std::uint32_t, 3> cells{1, 1, 1};
  double mean = 10;  // molecules of each species and voxel at the start
  std::string law;
  std::function<double(const rdme::State&, std::size_t voxels)> deviations;  // standard normal where all is right
};

std::uint64_t events_of(const rdme::State& state) { return state.reaction_events + state.jump_events; }

void judge(const Problem& problem, const rdme::Network& network, const rdme::State& state, std::size_t voxels,
           Measurement& measurement) {
  const double off = problem.deviations(state, voxels);
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
  judge(problem, network, state, voxels.size(), measurement);
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
  const double off = problem.deviations(state, voxels.size());
  measurement.right = std::abs(off) < most_deviations;
  measurement.check = fmt::format("{}: {:+.2f} standard deviations", problem.law, off);
  return measurement;
}

// About this many events a call of advance(), so that exact methods are timed in portions.
double portion(double events_per_second) { return 2e5 / events_per_second; }

void add(std::vector<Workload>& all, const std::string& name, const std::string& method, const Problem& problem,
         scene::Sampler sampler, double dt) {
  all.push_back({name, method, "events per CPU second",
                 [=](double seconds) { return with_sampler(problem, sampler, dt, seconds); }});
}

void add_heap(std::vector<Workload>& all, const std::string& name, const Problem& problem) {
  all.push_back({name, "exact-next-subvolume-heap", "events per CPU second",
                 [=](double seconds) { return with_heap(problem, seconds); }});
}

void add_diffusion(std::vector<Workload>& all, std::uint32_t n) {
  const auto name = fmt::format("D3-{}", n);
  const double voxels = double(n) * n * n;
  const Problem problem{diffusion_scene(), {n, n, n}, 10.0, "multinomial over the voxels", spread_over_voxels};
  add_heap(all, name, problem);
  if (n <= 10) add(all, name, "direct", problem, scene::Sampler::direct, 0.1 * portion(60.0 * voxels));
  add(all, name, "exact-composition-rejection", problem, scene::Sampler::composition_rejection, portion(60.0 * voxels));
  for (const double jumps : {0.6, 3.0})
    add(all, name, fmt::format("split-{:g}-jumps", jumps), problem, scene::Sampler::split, jumps / 6.0);
  add(all, name, "tau-3-jumps", problem, scene::Sampler::tau_leaping, 0.5);
}

void add_binding(std::vector<Workload>& all, std::uint32_t n) {
  const auto name = fmt::format("RD-{}", n);
  const double voxels = double(n) * n * n;
  const Problem problem{binding_scene(), {n, n, n}, 10.0, "A + B <-> C in equilibrium", distance_from_equilibrium};
  add_heap(all, name, problem);
  add(all, name, "exact-composition-rejection", problem, scene::Sampler::composition_rejection,
      portion(360.0 * voxels));
  for (const double jumps : {0.06, 0.6, 3.0})
    add(all, name, fmt::format("split-{:g}-jumps", jumps), problem, scene::Sampler::split, jumps / 6.0);
  add(all, name, "tau-0.6-jumps", problem, scene::Sampler::tau_leaping, 0.1);
}

// All species of the ring are equal: multinomial over them as over voxels.
double spread_over_species(const rdme::State& state, std::size_t) {
  double total = 0.0, chi2 = 0.0;
  for (const auto n : state.count) total += double(n);
  const double mean = total / double(state.species), degrees = double(state.species) - 1.0;
  for (const auto n : state.count) chi2 += (double(n) - mean) * (double(n) - mean) / mean;
  return (chi2 - degrees) / std::sqrt(2.0 * degrees);
}

// 2 M <-> D at equal numbers: the mean of M at equilibrium from mass action, its variance from detailed balance,
// P(D) ~ K^D/(M! D!): 4 M D/(M + 4 D).
double dimer_deviation(const rdme::State& state, std::size_t) {
  const double D = double(state.count[0]), M = double(state.count[1]), total = M + 2.0 * D;
  const double K = 10.0 / 1000.0;  // k/back, as in dimer below
  const double m = (std::sqrt(1.0 + 8.0 * K * total) - 1.0) / (4.0 * K), d = 0.5 * (total - m);
  return (M - m) / std::sqrt(4.0 * m * d / (m + 4.0 * d));
}

}  // namespace

std::vector<Workload> chemistry_workloads() {
  std::vector<Workload> all;
  for (const std::uint32_t n : {10u, 30u, 60u, 100u}) add_diffusion(all, n);
  for (const std::uint32_t n : {10u, 30u, 60u}) add_binding(all, n);
  const Problem dimer{dimer_scene(0.01, 1.0), {1, 1, 1}, 1e5 / 3.0, "2 M <-> D in equilibrium", dimer_deviation};
  for (const int n : {10, 100}) {
    const Problem ring{ring_scene(n), {1, 1, 1}, 1000.0, "multinomial over the species", spread_over_species};
    add(all, fmt::format("ring-{}", n), "direct", ring, scene::Sampler::direct, portion(1000.0 * n));
    add(all, fmt::format("ring-{}", n), "exact-composition-rejection", ring, scene::Sampler::composition_rejection,
        portion(1000.0 * n));
    add(all, fmt::format("ring-{}", n), "tau", ring, scene::Sampler::tau_leaping, 10.0);
  }
  add(all, "dimer", "direct", dimer, scene::Sampler::direct, portion(1e5));
  add(all, "dimer", "exact-composition-rejection", dimer, scene::Sampler::composition_rejection, portion(1e5));
  add(all, "dimer", "tau", dimer, scene::Sampler::tau_leaping, 10.0);
  return all;
}

}  // namespace shmoo::run::bench
