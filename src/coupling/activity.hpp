#pragma once
// How busy a run will be in its course: the mean number of events per second, foretold by the deterministic solution on
// a coarse likeness of the voxels. A feedback or a slow binding changes it by far more than a run's first second shows.
#include <array>
#include <functional>
#include <vector>

#include "rdme/network.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

// Events [1/s]: jumps as they are among the voxels themselves, each as heavy as the propensities that it makes anew,
// and reactions about (half of what is created and destroyed); means over equal parts of the run. From where `stop`
// told to, the last goes on; empty if that was at the start. `period` as for rdme::lump.
std::vector<double> foretell_activity(const scene::Scene& scene, const rdme::Voxels& voxels,
                                      const std::array<double, 3>& period, const std::function<bool()>& stop);

}  // namespace shmoo::coupling
