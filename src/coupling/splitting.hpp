#pragma once
// How long one splitting step may be, and why.
#include <string>
#include <vector>

#include "rdme/network.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

struct Step {
  double value = 0;  // [s]; infinite where nothing is split
  std::string why;
};

// The largest concentration of each species that the scene names (initial, boundary, inflow), carried on to the
// products of reactions [molecules/m^3]. Zero where nothing tells. `start` [molecules/m^3], by species, is known
// besides.
std::vector<double> reference_concentrations(const scene::Scene& scene, std::vector<double> start = {});

// The rate [1/s] at which each species is used up by mass action at these concentrations.
std::vector<double> turnover(const scene::Scene& scene, const std::vector<double>& reference);

// The step between deterministic and sampled chemistry (and between reactions and diffusion in the split sampler): a
// hundredth of the time scale of the fastest reaction at the reference concentrations, as the error of Strang splitting
// is of second order in that ratio (Strang 1968). A given numerics.splitting_step is taken as it is.
Step splitting_step(const scene::Scene& scene, const rdme::Network& network);

}  // namespace shmoo::coupling
