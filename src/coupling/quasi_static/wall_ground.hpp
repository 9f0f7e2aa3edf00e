#pragma once
// The wall as chemistry sees it: its particles as voxels, jumps round and through it, and what enters around its tip.
// Particles of the filling follow as voxels without chemistry.
#include "coupling/quasi_static/wall.hpp"
#include "coupling/stage.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::coupling {

// `sampler` may be null: no species is stochastic.
std::shared_ptr<const Ground> wall_ground(const WallPlan& plan, const Wall& wall, const rdme::Sampler* sampler);

// Moves amounts and molecules as columns were laid anew. `step` addresses the random numbers.
void redistribute(rdme::State& state, const rdme::Network& network, std::span<const hydro::Take> takes,
                  const base::RandomKey& key, std::uint64_t step);

}  // namespace shmoo::coupling
