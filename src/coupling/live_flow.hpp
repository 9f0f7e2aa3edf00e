#pragma once
// The one place where the coupling meets what moves: a fluid or solids in motion, told by persistent id and for voxels
// only.
#include <functional>
#include <memory>
#include <vector>

#include "base/random.hpp"
#include "coupling/experiment.hpp"
#include "coupling/frame.hpp"
#include "scene/scene.hpp"
#include "sph/fill.hpp"

namespace shmoo::coupling {

inline constexpr double most_movement = 0.25;          // [spacings] of a particle in one interval
inline constexpr double steps_between_feelings = 100;  // of the motion, where species act back on it
inline constexpr double part_of_time_scale = 0.25;  // of the flow's shortest, between two looks at whether it is steady

template <int D>
class LiveFlow {
 public:
  virtual ~LiveFlow() = default;

  // How far the species' interval may reach: particles move at most a quarter of a spacing in it. [s]
  virtual double interval() const = 0;

  // To time `until` exactly [s]. Where `frame` is not null it receives the mean positions, arrivals and mean drift.
  virtual void advance(double until, Frame<D>* frame) = 0;

  // What species do to the motion, where they do (softening). `concentration(species, id)` [1/m^3].
  virtual void feel(const std::function<double(int, std::uint32_t)>& concentration) = 0;

  virtual void picture(FlowPicture<D>& picture) const = 0;

  // Whether the velocity field has stopped to change, to numerics.steady_tolerance; false where none is given.
  virtual bool steady() const = 0;

  virtual std::uint64_t steps() const = 0;  // taken so far
  virtual std::vector<Experiment::Derived> derived() const = 0;
  // What only the run has shown.
  virtual std::vector<Experiment::Derived> told() const { return {}; }
};

// Of a scene in which something moves: its fluid, with its solids where there are, or its solids alone. Throws
// base::InputError in 1-D, where nothing moves. `key` addresses the thermal noise.
template <int D>
std::unique_ptr<LiveFlow<D>> make_live_flow(const scene::Scene& scene, const base::RandomKey& key);

}  // namespace shmoo::coupling
