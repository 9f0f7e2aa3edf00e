// Molecules that meet while they walk.
#include <cmath>
#include <numbers>

#include "run/verify/chemistry/experiment.hpp"
#include "run/verify/jump_chain.hpp"

namespace shmoo::run::verify {
namespace {

// A + B <-> C with diffusion over four voxels in equilibrium: the total of C has the law of one voxel of their volume
// (product of Poisson laws given A + C and B + C).
Experiment product_form() {
  const double volume = 4.0;
  const auto law = balanced_law(
      41, [&](double c) { return 0.5 / volume * (40.0 - c) * (48.0 - c); }, [](double c) { return 2.0 * c; });
  Experiment experiment{row_of(4,
                               species("A", 10) + species("B", 12) + species("C", 0) +
                                   reaction("A + B <-> C", "0.5 m^3/(s molecule)", "2 1/s"),
                               "6 s", "0.02 s"),
                        "C", law};
  experiment.realisations = 1500;
  return experiment;
}

// A + B -> nothing from apart: what annihilates takes one of each, so the mean of A - B walks as if they never met. In
// the left half of ten voxels: modes cos(pi k (i + 1/2)/10) decay at 4 sin^2(pi k/20).
Experiment annihilation() {
  constexpr int n = 10, molecules = 60;
  const double until = 8.0, pi = std::numbers::pi;
  std::vector<double> mean(n, 0.0);
  for (int k = 1; k < n; ++k) {
    double amplitude = 0.0;
    for (int i = 0; i < n; ++i)
      amplitude += 2.0 / n * (i < n / 2 ? 1.0 : -1.0) * molecules / (n / 2) * std::cos(pi * k * (i + 0.5) / n);
    const double decay = std::exp(-4.0 * std::pow(std::sin(pi * k / (2.0 * n)), 2) * until);
    for (int i = 0; i < n; ++i) mean[std::size_t(i)] += amplitude * decay * std::cos(pi * k * (i + 0.5) / n);
  }
  Experiment experiment{
      row_of(n,
             species("A", 0) + species("B", 0) + start_in("A", molecules, 0, n / 2) +
                 start_in("B", molecules, n / 2, n) + reaction("A + B -> nothing", "0.5 m^3/(s molecule)"),
             "8 s", "1 s"),
      "A"};
  experiment.minus = "B";
  experiment.voxels = n / 2;
  experiment.mean = 0.0;
  for (int i = 0; i < n / 2; ++i) experiment.mean += mean[std::size_t(i)];
  experiment.realisations = 2000;
  return experiment;
}

// Ligands in three voxels bind receptors in a wall voxel beside the last: in equilibrium the number bound has the law
// of one well of three voxels.
Experiment surface_binding() {
  const auto law = balanced_law(
      16, [](double b) { return 0.9 / 3.0 * (24.0 - b) * (15.0 - b); }, [](double b) { return 1.5 * b; });
  Experiment experiment{row_of(4, R"toml([materials.wall]
type = "still"
[[region]]
shape = "box"
lower = ["0 m"]
upper = ["3 m"]
material = "medium"
[[region]]
shape = "box"
lower = ["3 m"]
upper = ["4 m"]
material = "wall"
[species.L]
in = "medium"
diffusivity = "1 m^2/s"
initial = "8 molecules/m^3"
[species.R]
in = "wall"
initial = "15 molecules/m^3"
[species.B]
in = "wall"
[[reaction]]
equation = "L + R <-> B"
surface = ["wall", "medium"]
forward = "0.9 m^3/(s molecule)"
backward = "1.5 1/s"
)toml",
                               "30 s", "30 s"),
                        "B", law};
  experiment.realisations = 2000;
  experiment.samplers = {"direct", "composition_rejection"};
  return experiment;
}

}  // namespace

std::vector<NamedExperiment> meetings() {
  return {{"product-form", "A + B <-> C with diffusion, in equilibrium", product_form},
          {"annihilation", "A + B -> nothing from apart: A - B walks on", annihilation},
          {"surface-binding", "L in a medium and R in a wall bind where these touch", surface_binding}};
}

}  // namespace shmoo::run::verify
