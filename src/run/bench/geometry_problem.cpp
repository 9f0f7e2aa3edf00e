// Chemistry on the geometry of real scenes: MinL, Min oscillations on a lattice with a membrane, and D-sph, diffusion
// on particles that move with a flow and change their jump rates in every step of it.
#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "base/clock.hpp"
#include "coupling/geometry.hpp"
#include "coupling/live_flow.hpp"
#include "rdme/initial.hpp"
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

Measurement min_on_lattice(double seconds) {
  const auto scene = scene::read_scene_text(min_box + min_reactions, "bench.toml");
  const rdme::Network network(scene);
  const auto filling = sph::fill<3>(scene);
  const auto voxels = coupling::Geometry<3>(scene, filling).voxels(standing(filling));
  auto state = rdme::initial_state(scene, network, voxels, {1, 0});
  const double before = allocated_bytes();
  const auto sampler = rdme::make_sampler(scene::Sampler::composition_rejection, network);
  sampler->bind(voxels, state);
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / double(voxels.size());
  const double start = base::cpu_seconds(), dt = 0.02;
  std::uint64_t step = 0;
  do {
    sampler->advance(dt * double(step), dt, rdme::Process::both, {1, 0}, step);
    ++step;
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate = double(state.reaction_events + state.jump_events) / measurement.cpu_seconds;
  std::int64_t total = 0;  // MinE counts once, MinD once: de holds one of each
  for (int s = 0; s < 5; ++s) total += rdme::total_count(state, s) * (network.name(s) == "de" ? 2 : 1);
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && total == 4500 + 1575;
  measurement.check = fmt::format("{} molecules of 6075 after {:g} s", total, dt * double(step));
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

constexpr double events_per_particle_step = 1.0, molecules = 10.0;

// Of the chemistry alone: in each step of the flow all jump rates are made anew and the molecules jump.
Measurement on_moving_particles(scene::Sampler method, double seconds) {
  auto scene = scene::read_scene_text(vortices, "bench.toml");
  const auto flow = coupling::make_live_flow<3>(scene, {1, 0});
  coupling::Frame<3> frame;
  flow->advance(1e-3, nullptr);
  const double dt = 1e-3 / double(flow->steps());
  const double h = scene.domain.spacing;  // a jump through kernel weights goes 1.5 h or so: 6 D/(2.25 h^2) a second
  scene.species[0].diffusivity = events_per_particle_step / molecules / dt * 2.25 * h * h / 6.0;
  const rdme::Network network(scene);
  const auto filling = sph::fill<3>(scene);
  const coupling::Geometry<3> geometry(scene, filling);
  const double particles = double(filling.voxels);
  auto state = rdme::initial_state(scene, network, geometry.voxels(standing(filling)), {1, 0});
  fill_poisson(state, molecules);
  rdme::open_ledger(state, network);
  const auto sampler = rdme::make_sampler(method, network);
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
    voxels = geometry.voxels(frame, {true});
    sampler->bind(voxels, state);
    lap(refreshing);
    sampler->advance(t, dt, rdme::Process::both, {1, 0}, step);
    lap(jumping);
  }
  const double steps = double(flow->steps() - begun) * particles;
  Measurement measurement;
  measurement.cpu_seconds = refreshing + jumping;
  measurement.rate = steps / measurement.cpu_seconds;
  const double off = spread_over_voxels(counts_of(state));
  const auto lost = rdme::imbalance(state, network);
  measurement.right = lost.empty() && std::abs(off) < 5.0;
  measurement.check = fmt::format(
      "multinomial: {:+.2f} standard deviations; a particle-step: flow {:.2f} us, rates {:.2f} us, {:.2f} events "
      "{:.2f} "
      "us: {:.1f} x the flow",
      off, 1e6 * flowing / steps, 1e6 * refreshing / steps, double(state.jump_events) / steps, 1e6 * jumping / steps,
      measurement.cpu_seconds / flowing);
  return measurement;
}

}  // namespace

std::vector<Workload> geometry_workloads() {
  std::vector<Workload> all;
  all.push_back({"MinL", "exact-composition-rejection", "events per CPU second", min_on_lattice});
  for (const auto& [name, method] :
       {std::pair{"exact-composition-rejection", scene::Sampler::composition_rejection},
        std::pair{"split", scene::Sampler::split}, std::pair{"tau", scene::Sampler::tau_leaping}})
    all.push_back({"D-sph", name, "particle-steps per CPU second",
                   [method = method](double seconds) { return on_moving_particles(method, seconds); }});
  return all;
}

}  // namespace shmoo::run::bench
