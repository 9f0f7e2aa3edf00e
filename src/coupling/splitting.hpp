#pragma once
// How long one splitting step may be, and why.
#include <string>
#include <vector>

#include "coupling/experiment.hpp"
#include "rdme/network.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

struct Step {
  double value = 0;  // [s]; infinite where nothing is split
  std::string why;
  double error = 0;  // that it is expected to cost, relative; 0: not known or none
};

// For the result: what the step is expected to cost.
inline Experiment::Derived splitting_error(const Step& step) {
  return {"splitting error", step.error, "1", "of amounts, that the splitting step is expected to cost"};
}

// The largest concentration of each species that the scene names (initial, boundary, inflow), carried on to the
// products of reactions [molecules/m^3]. Zero where nothing tells. `start` [molecules/m^3], by species, is known
// besides.
std::vector<double> reference_concentrations(const scene::Scene& scene, std::vector<double> start = {});

// The rate [1/s] at which each species is used up by mass action at these concentrations.
std::vector<double> turnover(const scene::Scene& scene, const std::vector<double>& reference);

// The step between parts of the chemistry that are taken in turns: kinds of treatment that meet in a reaction, and
// reactions and diffusion in the samplers that part them. It is the longest whose error on a deterministic twin
// (splitting_twin.hpp) is within numerics.splitting_tolerance. A given numerics.splitting_step is taken as it is.
// `start` as above.
Step splitting_step(const scene::Scene& scene, const rdme::Network& network, const std::vector<double>& start = {});

}  // namespace shmoo::coupling
