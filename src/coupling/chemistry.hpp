#pragma once
// The chemistry of one realisation: its amounts, the sampler of its stochastic part and the solver of its deterministic part,
// joined by operator splitting.
#include <memory>

#include "base/random.hpp"
#include "rdme/deterministic.hpp"
#include "rdme/network.hpp"
#include "rdme/sampler.hpp"
#include "rdme/state.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

class Chemistry {
 public:
  Chemistry(const scene::Scene& scene, const rdme::Network& network, const base::RandomKey& key);

  // Draws the initial amounts for these voxels.
  void begin(std::shared_ptr<const rdme::Voxels> voxels);

  // From t to t + dt [s] in voxels that keep their shape. Lie: deterministic, then stochastic; Strang: half of the
  // deterministic part before and half after. `interval` numbers the calls of one realisation.
  void advance(std::shared_ptr<const rdme::Voxels> voxels, double t, double dt, std::uint64_t interval);

  const rdme::State& state() const { return state_; }
  const rdme::Voxels& voxels() const { return *voxels_; }

 private:
  void bind(std::shared_ptr<const rdme::Voxels> voxels);

  const scene::Scene& scene_;
  const rdme::Network& network_;
  base::RandomKey key_;
  rdme::State state_;
  std::shared_ptr<const rdme::Voxels> voxels_;
  std::unique_ptr<rdme::Sampler> sampler_;               // null where no species is stochastic
  std::unique_ptr<rdme::DeterministicSolver> solver_;    // null where no species is deterministic
};

}  // namespace shmoo::coupling
