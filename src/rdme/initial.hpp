#pragma once
// What is there at the start.
#include "base/random.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::rdme {

// Fills the state from Scene::initials and opens its ledger. An entry covers the voxels of its species' homes that lie
// in its material and shape; where entries of a species overlap the later one holds.
// * A concentration gives each voxel C V molecules: exactly so for a deterministic species; for a stochastic one the
// whole part,
//   and one more with the probability of the rest, so that the mean is exact.
// * A count is spread over the volume that the entry covers and no later one takes: in proportion for a deterministic
// species,
//   multinomially for a stochastic one. Its total is exact either way.
// Chance is addressed by (key, species, voxel) and (key, species, entry), so a realisation does not depend on any
// other. Throws base::InputError: an entry that covers no voxel, a stochastic count that is no whole number, a negative
// or undefined concentration, an expression that cannot be used.
State initial_state(const scene::Scene& scene, const Network& network, const Voxels& voxels,
                    const base::RandomKey& key);

}  // namespace shmoo::rdme
