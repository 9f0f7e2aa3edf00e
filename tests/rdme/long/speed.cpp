// Events per CPU second on the workloads of the next-subvolume literature, printed. D3-n: a periodic lattice of n^3
// voxels, one species, 10 molecules a voxel, jump rate 1 per face. RD-n: A + B -> C at 0.9 A B and C -> A + B at 9 C,
// all three diffuse with rate 1 per face, 10/10/10 a voxel, equal numbers of reactions and jumps.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <ctime>

#include "../lattice.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::rdme {
namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

scene::Scene diffusion_scene() {
  scene::Scene scene = water();
  add_species(scene, "A", 1.0);
  return scene;
}

scene::Scene reaction_scene() {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0), b = add_species(scene, "B", 1.0), c = add_species(scene, "C", 1.0);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 0.9);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 9.0);
  return scene;
}

// Events per CPU second over about `events` events in steps of `dt`.
double rate(scene::Sampler method, const scene::Scene& scene, std::uint32_t n, double dt, double events) {
  const Network network(scene);
  const Voxels voxels = lattice({n, n, n}, true, 1.0, network.species());
  State state = empty_state(network, voxels.size());
  for (int s = 0; s < static_cast<int>(network.species()); ++s) fill(state, s, 10);
  open_ledger(state, network);
  auto sampler = make_sampler(method, network);
  sampler->bind(voxels, state);
  sampler->advance(0, dt, Process::both, {1, 0}, 0);
  const auto done = [&] { return static_cast<double>(state.reaction_events + state.jump_events); };
  const double before = done(), start = cpu_seconds();
  for (std::uint64_t step = 1; done() - before < events; ++step) sampler->advance(0, dt, Process::both, {1, 0}, step);
  const double speed = (done() - before) / (cpu_seconds() - start);
  EXPECT_EQ(imbalance(state, network), "");
  return speed;
}

TEST(Speed, CompositionRejection) {
  const auto method = scene::Sampler::composition_rejection;
  for (std::uint32_t n : {10U, 30U, 60U}) {
    fmt::print("composition_rejection D3-{}: {:.1f} million events per CPU second\n", n,
               1e-6 * rate(method, diffusion_scene(), n, 1.0, 2e7));
  }
  for (std::uint32_t n : {10U, 30U}) {
    fmt::print("composition_rejection RD-{}: {:.1f} million events per CPU second\n", n,
               1e-6 * rate(method, reaction_scene(), n, 1.0, 1e7));
  }
}

}  // namespace
}  // namespace shmoo::rdme
