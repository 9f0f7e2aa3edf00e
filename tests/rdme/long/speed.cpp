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

struct Speed {
  double events;  // per CPU second
  double bind;    // CPU seconds
};

// Over about `events` events in steps of `dt`.
Speed measure(scene::Sampler method, const scene::Scene& scene, const Voxels& voxels, std::int64_t each, double dt,
              double events) {
  const Network network(scene);
  State state = empty_state(network, voxels.size());
  for (int s = 0; s < static_cast<int>(network.species()); ++s) fill(state, s, each);
  open_ledger(state, network);
  auto sampler = make_sampler(method, network);
  const double begin = cpu_seconds();
  sampler->bind(voxels, state);
  const double bind = cpu_seconds() - begin;
  sampler->advance(0, dt, Process::both, {1, 0}, 0);
  const auto done = [&] { return static_cast<double>(state.reaction_events + state.jump_events); };
  const double before = done(), start = cpu_seconds();
  for (std::uint64_t step = 1; done() - before < events; ++step) sampler->advance(0, dt, Process::both, {1, 0}, step);
  const double spent = cpu_seconds() - start;
  EXPECT_EQ(imbalance(state, network), "");
  return {(done() - before) / spent, bind};
}

void show(const char* method, const std::string& work, const Speed& speed) {
  fmt::print("{:22} {:40} {:7.1f} million events per CPU second; bind {:.1f} ms\n", method, work, 1e-6 * speed.events,
             1e3 * speed.bind);
}

Voxels cube(std::uint32_t n, std::size_t species) { return lattice({n, n, n}, true, 1.0, species); }

class SpeedOf : public testing::TestWithParam<std::uint32_t> {};

// What one event costs as the lattice grows, and why: valgrind --tool=cachegrind long_rdme
// --gtest_filter='*SpeedOf.DiffusionAlone/100', built for a processor that valgrind knows (SHMOO_ARCH=x86-64-v3).
TEST_P(SpeedOf, DiffusionAlone) {
  show("composition_rejection", fmt::format("D3-{}", GetParam()),
       measure(scene::Sampler::composition_rejection, diffusion_scene(), cube(GetParam(), 1), 10, 1.0, 2e7));
}

INSTANTIATE_TEST_SUITE_P(Voxels, SpeedOf, testing::Values(10U, 30U, 60U, 100U), testing::PrintToStringParamName());

TEST(Speed, CompositionRejection) {
  const auto method = scene::Sampler::composition_rejection;
  for (std::uint32_t n : {10U, 30U}) {
    show("composition_rejection", fmt::format("RD-{}", n), measure(method, reaction_scene(), cube(n, 3), 10, 1.0, 1e7));
  }
  show("composition_rejection", "20164 disordered, 28 neighbours, 100 each",
       measure(method, diffusion_scene(), disordered(142, 1), 100, 1.0, 1e7));
}

TEST(Speed, Split) {
  const auto method = scene::Sampler::split;
  for (double dt : {0.02, 0.1, 0.5}) {
    show("split", fmt::format("D3-30, {:.2f} jumps a step", 6 * dt),
         measure(method, diffusion_scene(), cube(30, 1), 10, dt, 3e7));
  }
  show("split", "RD-10, step 0.02", measure(method, reaction_scene(), cube(10, 3), 10, 0.02, 5e6));
  for (double dt : {0.1, 0.6, 1.0, 3.0}) {
    for (std::int64_t each : {1, 10, 100, 1000, 10000}) {
      show("split", fmt::format("20164 disordered, {} each, {:.1f} jumps a step", each, dt),
           measure(method, diffusion_scene(), disordered(142, 1), each, dt,
                   std::min(3e7, 5e5 * static_cast<double>(each))));
    }
  }
}

}  // namespace
}  // namespace shmoo::rdme
