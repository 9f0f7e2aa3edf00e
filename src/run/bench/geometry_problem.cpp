// Chemistry on the geometry of real scenes: MinL, Min oscillations on a lattice with a membrane, and D-sph, diffusion
// on particles that move with a flow and change their jump rates in every step of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "base/clock.hpp"
#include "coupling/geometry.hpp"
#include "coupling/live_flow.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/initial.hpp"
#include "rdme/langevin.hpp"
#include "rdme/sampler.hpp"
#include "run/bench/lattice_problem.hpp"
#include "run/bench/problem.hpp"
#include "run/bench/workload.hpp"
#include "run/min_reactions.hpp"
#include "scene/read.hpp"

namespace shmoo::run::bench {
namespace {

// A box of 10 x 10 x 45 voxels of 0.1 um whose outermost layer is membrane, with the numbers of molecules of Fange and
// Elf 2006.
const std::string min_box = R"toml(
title = "bench"
dimension = 3
[domain]
size = ["1 um", "1 um", "4.5 um"]
spacing = "0.1 um"
material = "membrane"
[materials.cytoplasm]
type = "still"
[materials.membrane]
type = "still"
[[region]]
material = "cytoplasm"
shape = "box"
lower = ["0.1 um", "0.1 um", "0.1 um"]
upper = ["0.9 um", "0.9 um", "4.4 um"]
[species]
D_ADP = { in = "cytoplasm", diffusivity = "2.5 um^2/s" }
D_ATP = { in = "cytoplasm", diffusivity = "2.5 um^2/s" }
E = { in = "cytoplasm", diffusivity = "2.5 um^2/s" }
d = { in = "membrane", diffusivity = "0.01 um^2/s" }
de = { in = "membrane", diffusivity = "0.01 um^2/s" }
[[initial]]
species = "D_ATP"
count = "4500 molecules"
[[initial]]
species = "E"
count = "1575 molecules"
[numerics]
reach = 1.2
limits = "warn"
[run]
until = "1 s"
)toml";

template <int D>
coupling::Frame<D> standing(const sph::Filling<D>& filling) {
  coupling::Frame<D> frame;
  frame.position.assign(filling.particles.position.values().begin(),
                        filling.particles.position.values().begin() + long(filling.voxels));
  frame.capacity.assign(filling.voxels, filling.cell);
  frame.steady = true;
  return frame;
}

using Treatment = scene::SpeciesMethod;
constexpr auto both = rdme::Process::both;

// Any of the methods, as two verbs.
struct Method {
  std::function<void(const rdme::Voxels&, rdme::State&)> bind;
  std::function<void(double t, double dt, std::uint64_t step)> advance;
};

template <class Solver, class Advance>
Method method_of(std::shared_ptr<Solver> solver, Advance advance) {
  return {[solver](const rdme::Voxels& voxels, rdme::State& state) { solver->bind(voxels, state); },
          [solver, advance](double t, double dt, std::uint64_t step) { advance(*solver, t, dt, step); }};
}

Method make_method(Treatment treatment, scene::Sampler sampler, const rdme::Network& network) {
  if (treatment == Treatment::deterministic)
    return method_of(std::make_shared<rdme::DeterministicSolver>(network, 1e-6),
                     [](auto& solver, double t, double dt, std::uint64_t) { solver.advance(t, dt, both); });
  const auto drawn = [](auto& solver, double t, double dt, std::uint64_t step) {
    solver.advance(t, dt, both, {1, 0}, step);
  };
  if (treatment == Treatment::langevin) return method_of(std::make_shared<rdme::LangevinSolver>(network), drawn);
  return method_of(std::shared_ptr<rdme::Sampler>(rdme::make_sampler(sampler, network)), drawn);
}

void treat(scene::Scene& scene, Treatment treatment) {
  for (auto& species : scene.species) species.method = treatment;
}

// By events, or without noise by how much of space and time is carried along.
Measurement min_on_lattice(Treatment treatment, double seconds) {
  auto scene = scene::read_scene_text(min_box + min_reactions, "bench.toml");
  treat(scene, treatment);
  const bool smooth = treatment == Treatment::deterministic;
  const rdme::Network network(scene);
  const auto filling = sph::fill<3>(scene);
  const auto voxels = coupling::Geometry<3>(scene, filling).voxels(standing(filling));
  auto state = rdme::initial_state(scene, network, voxels, {1, 0});
  const double before = allocated_bytes();
  const auto method = make_method(treatment, scene::Sampler::composition_rejection, network);
  method.bind(voxels, state);
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size());
  const double start = base::cpu_seconds(), dt = 0.02;
  std::uint64_t step = 0;
  do {
    method.advance(dt * double(step), dt, step);
    ++step;
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  const double passed = dt * double(step);
  measurement.rate = (smooth ? double(voxels.size()) * passed : double(state.reaction_events + state.jump_events)) /
                     measurement.cpu_seconds;
  double total = 0;  // MinE counts once, MinD once: de holds one of each
  for (int s = 0; s < 5; ++s)
    total += (smooth ? rdme::total_amount(state, s) : double(rdme::total_count(state, s))) *
             (network.name(s) == "de" ? 2 : 1);
  const bool negative = std::ranges::any_of(state.amount, [](double n) { return n < 0.0; });
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && !negative && std::abs(total - 6075) <= (smooth ? 1e-9 * 6075 : 0.0);
  measurement.check = fmt::format("{:.10g} molecules of 6075 after {:g} s", total, passed);
  return measurement;
}

const char* const vortices = R"toml(
title = "bench"
dimension = 3
[domain]
size = ["1 m", "1 m", "1 m"]
spacing = "0.03333333333333333 m"
boundary = "periodic"
jitter = 0.2
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.01 Pa s"
[parameters]
U = "1 m/s"
k = "6.283185307179586 1/m"
[flow]
initial_velocity = ["-U * cos(k*x) * sin(k*y)", "U * sin(k*x) * cos(k*y)", "0 m/s"]
reference_speed = "1 m/s"
[effects]
transport_velocity = false
density_diffusion = false
species_advection = false
[species.A]
diffusivity = "1 m^2/s"
initial = "270000 molecules/m^3"
[run]
until = "1 s"
)toml";

constexpr double jumps_per_molecule_step = 0.1;
double molecules(Treatment treatment) { return treatment == Treatment::langevin ? 1000.0 : 10.0; }  // of a particle

// Multinomial numbers stay so; without noise, scattered ones become more even than those, and never negative.
void judge_spread(Treatment treatment, const rdme::State& state, const rdme::Network& network, double before,
                  Measurement& measurement) {
  const double off = spread_over_voxels(treatment == Treatment::stochastic ? counts_of(state) : amounts_of(state));
  const bool negative = std::ranges::any_of(state.amount, [](double n) { return n < 0.0; });
  const bool even = treatment == Treatment::deterministic ? off < before : std::abs(off) < 5.0;
  measurement.right = rdme::imbalance(state, network).empty() && !negative && even;
  measurement.check = treatment == Treatment::deterministic
                          ? fmt::format("scatter evens out: {:+.1f} to {:+.1f}", before, off)
                          : fmt::format("multinomial: {:+.2f} standard deviations", off);
}

// Of the chemistry alone: in each step of the flow all jump rates are made anew and the molecules jump.
Measurement on_moving_particles(Treatment treatment, scene::Sampler sampler, double seconds) {
  auto scene = scene::read_scene_text(vortices, "bench.toml");
  treat(scene, treatment);
  const auto flow = coupling::make_live_flow<3>(scene, {1, 0});
  coupling::Frame<3> frame;
  flow->advance(1e-3, nullptr);
  const double dt = 1e-3 / double(flow->steps());
  const double h = scene.domain.spacing;  // a jump through kernel weights goes 1.5 h or so: 6 D/(2.25 h^2) a second
  scene.species[0].diffusivity = jumps_per_molecule_step / dt * 2.25 * h * h / 6.0;
  const rdme::Network network(scene);
  const auto filling = sph::fill<3>(scene);
  const coupling::Geometry<3> geometry(scene, filling);
  const double particles = double(filling.voxels);
  auto state = rdme::initial_state(scene, network, geometry.voxels(standing(filling)), {1, 0});
  fill_poisson(state, molecules(treatment));
  const double scatter = spread_over_voxels(counts_of(state));
  const bool listed = treatment != Treatment::stochastic;
  if (listed) {
    state.amount.assign(state.count.begin(), state.count.end());
    std::ranges::fill(state.count, 0);
  }
  rdme::open_ledger(state, network);
  const auto method = make_method(treatment, sampler, network);
  double flowing = 0, refreshing = 0, jumping = 0, t = 1e-3, clock = base::cpu_seconds();
  const auto lap = [&](double& spent) {
    const double now = base::cpu_seconds();
    spent += now - clock;
    clock = now;
  };
  const auto begun = flow->steps();
  rdme::Voxels voxels;
  for (std::uint64_t step = 0; refreshing + jumping < seconds; ++step, t += dt) {
    flow->advance(t + dt, &frame);
    frame.capacity.assign(frame.position.size(), filling.cell);
    frame.drift.clear();
    lap(flowing);
    voxels = geometry.voxels(frame, {!listed});
    method.bind(voxels, state);
    lap(refreshing);
    method.advance(t, dt, step);
    lap(jumping);
  }
  const double steps = double(flow->steps() - begun) * particles;
  Measurement measurement;
  measurement.cpu_seconds = refreshing + jumping;
  measurement.rate = steps / measurement.cpu_seconds;
  judge_spread(treatment, state, network, scatter, measurement);
  measurement.check +=
      fmt::format("; a particle-step: flow {:.2f} us, rates {:.2f} us, {:.2f} events {:.2f} us: {:.1f} x the flow",
                  1e6 * flowing / steps, 1e6 * refreshing / steps, double(state.jump_events) / steps,
                  1e6 * jumping / steps, measurement.cpu_seconds / flowing);
  return measurement;
}

}  // namespace

std::vector<Workload> geometry_workloads() {
  std::vector<Workload> all;
  all.push_back({"MinL", "exact-composition-rejection", "events per CPU second",
                 [](double seconds) { return min_on_lattice(Treatment::stochastic, seconds); }});
  all.push_back({"MinL", "ode", "voxels a second each, per CPU s",
                 [](double seconds) { return min_on_lattice(Treatment::deterministic, seconds); }});
  const auto add = [&](const std::string& name, Treatment treatment, scene::Sampler sampler) {
    all.push_back({"D-sph", name, "particle-steps per CPU second",
                   [=](double seconds) { return on_moving_particles(treatment, sampler, seconds); }});
  };
  add("exact-composition-rejection", Treatment::stochastic, scene::Sampler::composition_rejection);
  add("split", Treatment::stochastic, scene::Sampler::split);
  add("tau", Treatment::stochastic, scene::Sampler::tau_leaping);
  add("langevin", Treatment::langevin, {});
  add("ode", Treatment::deterministic, {});
  return all;
}

}  // namespace shmoo::run::bench
