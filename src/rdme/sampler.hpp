#pragma once
// The verbs that every stochastic method offers. One file per method under src/rdme/samplers/.
//
// All methods sample the same process: reactions (network.hpp), jumps along the rows of Voxels::graphs, exits to and
// Poisson entries from what Voxels::exchanges names. `direct` and `composition_rejection` are exact; `split` takes
// reactions and diffusion in turns (Strang) and is exact for either alone; `tau_leaping` does the same with reactions
// in leaps. Rate laws that contain t are sampled exactly, too (propensity.hpp).
#include <cstdint>
#include <memory>

#include "base/random.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::rdme {

enum class Process { both, reactions, diffusion };  // what an advance acts on; diffusion includes all exchanges

// Whether reactions and diffusion are sampled in turns, so that a step costs accuracy but its events need not be drawn
// one by one.
inline bool takes_turns(scene::Sampler method) {
  return method == scene::Sampler::split || method == scene::Sampler::tau_leaping;
}

struct JumpTables;

// Looks at the state after every reaction event.
class EventWatch {
 public:
  virtual ~EventWatch() = default;
  virtual bool stops(double t) = 0;  // true: the advance ends here, at t [s]
};

class Sampler {
 public:
  virtual ~Sampler() = default;

  // What this method derives from the geometry alone. It never changes: share it between all samplers of the same
  // method and network that see the same voxels, in any thread. Throws base::RunError where a rate is negative or not
  // finite.
  virtual std::shared_ptr<const JumpTables> prepare(const Voxels& voxels) const = 0;

  // New geometry under the sampler's feet: derive everything again. References must outlive it. `tables` come from
  // prepare().
  virtual void bind(const Voxels& voxels, State& state, std::shared_ptr<const JumpTables> tables) = 0;
  void bind(const Voxels& voxels, State& state) { bind(voxels, state, prepare(voxels)); }

  // Counts or amounts were changed by someone else, at the same geometry. Much cheaper than bind().
  virtual void amounts_changed() = 0;

  // Who looks at the state after every reaction event from now on; null: nobody. Throws base::InputError where the method
  // does not go event by event.
  virtual void watch(EventWatch* watch);

  // From time t to t + dt [s] at frozen geometry. `step` addresses the random numbers and differs between calls.
  // Deterministic amounts are constant but for what stochastic events take from or add to them. Throws base::RunError
  // where a propensity is negative or not a number.
  virtual void advance(double t, double dt, Process process, const base::RandomKey& key, std::uint64_t step) = 0;
};

// The network must outlive the sampler. `method`: which, with default numerics otherwise.
std::unique_ptr<Sampler> make_sampler(const scene::Numerics& numerics, const Network& network);
std::unique_ptr<Sampler> make_sampler(scene::Sampler method, const Network& network);

// The same where all is one voxel, without jumps and exchanges.
std::unique_ptr<Sampler> make_well_sampler(scene::Sampler method, const Network& network);

}  // namespace shmoo::rdme
