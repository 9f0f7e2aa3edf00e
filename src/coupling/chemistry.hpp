#pragma once
// The chemistry of one realisation: its amounts, the sampler of its stochastic part and the solvers of its Langevin
// and deterministic parts, joined by operator splitting.
#include <functional>
#include <memory>

#include "base/random.hpp"
#include "coupling/experiment.hpp"
#include "coupling/stage.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/initial.hpp"
#include "rdme/langevin.hpp"
#include "rdme/network.hpp"
#include "rdme/sampler.hpp"
#include "rdme/state.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

class Chemistry {
 public:
  Chemistry(const scene::Scene& scene, const rdme::Network& network, const base::RandomKey& key);

  // Draws the initial amounts on this ground.
  void begin(std::shared_ptr<const Ground> ground);

  // From t to t + dt [s] on ground that keeps its shape. Lie: deterministic, Langevin, stochastic; Strang: half of the
  // first two before and, in reverse, half after. `interval` numbers the calls of one realisation.
  void advance(std::shared_ptr<const Ground> ground, double t, double dt, std::uint64_t interval);

  // Amounts and molecules are moved by someone else, in a way that the ledger need not know; the next advance comes on
  // new ground.
  void change(const std::function<void(rdme::State&)>& how) { how(state_); }

  // Voxels leave through open sides with all they hold, and others enter with what the side gives them, in this order;
  // `volume` [m^3] is that of a voxel that enters. The next advance, of this number, comes on new ground.
  void pass(const std::vector<Passage>& passages, double volume, std::uint64_t interval);

  // The ledger and what happened. Throws nothing: an imbalance is told in the outcome.
  void close(Outcome& outcome) const;

  const rdme::State& state() const { return state_; }

 private:
  void bind(std::shared_ptr<const Ground> ground);
  void leave(std::size_t voxel);
  void enter(const Passage& passage, int species, double molecules, std::uint64_t interval);

  const scene::Scene& scene_;
  const rdme::Network& network_;
  base::RandomKey key_;
  rdme::State state_;
  std::shared_ptr<const Ground> ground_;
  std::unique_ptr<rdme::Sampler> sampler_;             // null where no species is stochastic
  std::unique_ptr<rdme::DeterministicSolver> solver_;  // null where no species is deterministic
  std::unique_ptr<rdme::LangevinSolver> langevin_;     // null where no species is Langevin
};

}  // namespace shmoo::coupling
