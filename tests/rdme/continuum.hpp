#pragma once
// One network on hand-made voxels under the deterministic solver.
#include "rdme/deterministic.hpp"
#include "trial.hpp"

namespace shmoo::rdme {

inline constexpr auto deterministic = scene::SpeciesMethod::deterministic;

struct Continuum {
  Network network;
  Voxels voxels;
  State state;
  DeterministicSolver solver;
  double t = 0;

  Continuum(const scene::Scene& scene, Voxels on, double tolerance = 1e-6)
      : network(scene), voxels(std::move(on)), state(empty_state(network, voxels.size())), solver(network, tolerance) {}

  Continuum(const Continuum&) = delete;

  void begin() {
    open_ledger(state, network);
    solver.bind(voxels, state);
  }

  void run(double until, double dt, Process process = Process::both) {
    while (t < until * (1 - 1e-12)) {
      const double now = std::min(dt, until - t);
      solver.advance(t, now, process);
      t += now;
    }
    EXPECT_EQ(imbalance(state, network), "");
  }
};

}  // namespace shmoo::rdme
