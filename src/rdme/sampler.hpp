#pragma once
// The verbs that every stochastic method offers. One file per method under src/rdme/samplers/.
#include <cstdint>
#include <memory>

#include "base/random.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::rdme {

enum class Process { both, reactions, diffusion };  // what an advance acts on; diffusion includes all exchanges

class Sampler {
 public:
  virtual ~Sampler() = default;

  // The geometry or the amounts changed under the sampler's feet: derive everything again. References must outlive it.
  virtual void bind(const Voxels& voxels, State& state) = 0;

  // From time t to t + dt [s] at frozen geometry. `step` addresses the random numbers and differs between calls.
  // Deterministic amounts are constant but for what stochastic events take from or add to them.
  virtual void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) = 0;
};

std::unique_ptr<Sampler> make_sampler(scene::Sampler method, const Network& network);

}  // namespace shmoo::rdme
