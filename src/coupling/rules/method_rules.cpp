// Which species can be treated as smooth concentrations.
#include <cmath>

#include "coupling/rules/rule.hpp"

namespace shmoo::coupling {
namespace {

bool is_zero(double value, double) { return value == 0.0; }
bool below(double value, double threshold) { return value < threshold; }
bool any(double, double) { return true; }

double per_voxel(const SpeciesNumbers& species) { return species.per_voxel; }
double variation(const SpeciesNumbers& species) { return 1.0 / std::sqrt(species.per_voxel); }
double seeds(const SpeciesNumbers& species) {
  return species.catalyses_itself ? species.least : std::numeric_limits<double>::infinity();
}

// Fluctuations of n molecules in a voxel are 1/sqrt(n) of the mean; they shift the mean of a nonlinear network by a
// relative 1/n.
constexpr MethodRule rules[] = {
    {"molecules per voxel", 0.0, "nothing to judge by: the sampled treatment is right for any number", per_voxel,
     is_zero, true, "the scene names no amount of it"},
    {"molecules per voxel at the start, where fewest, of a species that catalyses itself", 1e4,
     "van Kampen, Stochastic Processes in Physics and Chemistry, ch. X: growth from few amplifies their chance", seeds,
     below, true, "{:.3g} molecules or fewer in a voxel at the start, and chance grows with it"},
    {"molecules per voxel", 1e4, "Kurtz 1972, Gillespie 2000: fluctuations 1/sqrt(n) of the mean, 1 % at 10^4",
     per_voxel, below, true, "{:.3g} molecules in a voxel fluctuate by more than 1 %"},
    {"coefficient of variation in a voxel, 1/sqrt(n)", 0.01, "Kurtz 1972, Gillespie 2000", variation, any, false,
     "molecules in a voxel fluctuate by {:.2g} of their number"},
};

}  // namespace

std::span<const MethodRule> method_rules() { return rules; }

}  // namespace shmoo::coupling
