// Which species are counted, which are smooth amounts with noise, and which smooth concentrations.
#include <cmath>

#include "coupling/rules/rule.hpp"

namespace shmoo::coupling {
namespace {

using scene::SpeciesMethod;

bool is_zero(double value, double) { return value == 0.0; }
bool below(double value, double threshold) { return value < threshold; }
bool at_most(double value, double threshold) { return value <= threshold; }
bool at_least(double value, double threshold) { return value >= threshold; }
bool any(double, double) { return true; }

double per_voxel(const SpeciesNumbers& species) { return species.per_voxel; }
double least(const SpeciesNumbers& species) { return species.least; }
double surfaces(const SpeciesNumbers& species) { return species.surfaces; }
double variation(const SpeciesNumbers& species) { return 1.0 / std::sqrt(species.per_voxel); }
double seeds(const SpeciesNumbers& species) {
  return species.catalyses_itself ? species.least : std::numeric_limits<double>::infinity();
}

// Fluctuations of n molecules in a voxel are 1/sqrt(n) of the mean; they shift the mean of a nonlinear network by a
// relative 1/n.
constexpr MethodRule rules[] = {
    {"molecules per voxel", 0.0, "nothing to judge by: the sampled treatment is right for any number", per_voxel,
     is_zero, SpeciesMethod::stochastic, "the scene names no amount of it"},
    {"molecules per voxel at the start, where fewest, of a species that catalyses itself", 1e4,
     "van Kampen, Stochastic Processes in Physics and Chemistry, ch. X: growth from few amplifies their chance", seeds,
     below, SpeciesMethod::stochastic, "{:.3g} molecules or fewer in a voxel at the start, and chance grows with it"},
    {"coefficient of variation in a voxel, 1/sqrt(n)", 0.01, "Kurtz 1972, Gillespie 2000", variation, at_most,
     SpeciesMethod::deterministic, "molecules in a voxel fluctuate by {:.2g} of their number, which is neglected"},
    {"molecules per voxel", 1e3, "Gillespie 2000: noise is smooth where a voxel holds many", per_voxel, below,
     SpeciesMethod::stochastic,
     "{:.3g} molecules in a voxel fluctuate by more than 1 %, and are too few for smooth noise"},
    {"reactions on surfaces that it takes part in", 1, "such a reaction joins two voxels, event by event", surfaces,
     at_least, SpeciesMethod::stochastic, "it takes part in {:g} reactions on surfaces, whose noise is not smooth"},
    {"molecules per voxel at the start, where fewest", 100, "Gillespie 2000: noise is smooth where a voxel holds many",
     least, below, SpeciesMethod::stochastic,
     "{:.3g} molecules in a voxel at the start, where fewest, are too few for smooth noise"},
    {"molecules per voxel", 1e4, "Kurtz 1972, Gillespie 2000: fluctuations 1/sqrt(n) of the mean, 1 % at 10^4",
     per_voxel, any, SpeciesMethod::langevin,
     "{:.3g} molecules in a voxel fluctuate by more than 1 %, smoothly; means err by about 1/n"},
};

}  // namespace

std::span<const MethodRule> method_rules() { return rules; }

}  // namespace shmoo::coupling
