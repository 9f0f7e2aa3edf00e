// Molecules that do not meet: each is a walker of its own, and numbers are binomial.
#include <cmath>

#include "run/verify/chemistry/experiment.hpp"
#include "run/verify/jump_chain.hpp"

namespace shmoo::run::verify {
namespace {

constexpr std::size_t row = 10;  // voxels

std::vector<ChainJump> walk(std::size_t voxels) {
  std::vector<ChainJump> jumps;
  for (std::size_t i = 0; i < voxels; ++i) {
    if (i > 0) jumps.push_back({i, i - 1, 1.0});
    if (i + 1 < voxels) jumps.push_back({i, i + 1, 1.0});
  }
  return jumps;
}

const std::string walker = "[species.X]\ndiffusivity = \"1 m^2/s\"\n";
const std::string absorbing = "[[boundary]]\nspecies = \"X\"\nat = \"x_max\"\ntype = \"absorb\"\n";

// Forty walkers on ten voxels, all from the left end; whoever reaches the right side is gone. The side is half a voxel
// from the last voxel's middle, so it takes molecules at twice the rate of a jump.
Experiment first_passage() {
  auto jumps = walk(row);
  jumps.push_back({row - 1, row, 2.0});
  const double left = 1.0 - chain_law(row + 1, jumps, 0, 60.0)[row];
  Experiment experiment{row_of(int(row), walker + start_in("X", 40, 0, 1) + absorbing, "60 s", "5 s"), "X",
                        binomial_law(40, left)};
  experiment.realisations = 1500;
  return experiment;
}

// Ticks at one a second while a walker lives count its life: n^2/(2 q) on average from the left end of n voxels, as the
// step from voxel i on takes i/q, and the last n/(2 q).
Experiment mean_passage() {
  const std::string clock = "[species.T]\ndiffusivity = \"0 m^2/s\"\n" + reaction("X -> X + T", "1 1/s");
  Experiment experiment{row_of(int(row), walker + clock + start_in("X", 4, 0, 1) + absorbing, "3000 s", "3000 s"), "T"};
  experiment.mean = 4.0 * double(row * row) / 2.0;
  experiment.realisations = 1000;
  experiment.samplers = {"direct", "composition_rejection"};
  return experiment;
}

// Hundred walkers from the left end: how many are in the left half is binomial, whatever the splitting step, with
// `jumps` jumps a molecule and step.
Experiment multinomial(double jumps) {
  const double until = std::max(20.0, jumps);
  double left = 0.0;
  const auto law = chain_law(row, walk(row), 0, until);
  for (std::size_t i = 0; i < row / 2; ++i) left += law[i];
  Experiment experiment{row_of(int(row), walker + start_in("X", 100, 0, 1), std::to_string(until) + " s",
                               std::to_string(jumps / 2.0) + " s"),
                        "X", binomial_law(100, left)};
  experiment.voxels = row / 2;
  experiment.realisations = 1500;
  experiment.samplers = {"split"};
  if (jumps == 3.0) experiment.samplers = {"direct", "composition_rejection", "split"};
  return experiment;
}

// A -> B -> C -> A and losses while they walk over three voxels at different speeds: where one molecule is after a
// while follows from the exponential of a matrix of nine states and one for gone.
Experiment first_order() {
  std::vector<ChainJump> jumps;
  const double speed[] = {1.0, 0.5, 2.0}, change[] = {0.8, 1.2, 0.4};
  for (std::size_t s = 0; s < 3; ++s) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t at = 3 * s + i;
      if (i > 0) jumps.push_back({at, at - 1, speed[s]});
      if (i < 2) jumps.push_back({at, at + 1, speed[s]});
      jumps.push_back({at, 3 * ((s + 1) % 3) + i, change[s]});
      if (s == 1) jumps.push_back({at, 9, 0.1});
    }
  }
  const auto law = chain_law(10, jumps, 0, 2.0);
  Experiment experiment{
      row_of(3,
             species("A", 0) + species("B", 0, "0.5 m^2/s") + species("C", 0, "2 m^2/s") + start_in("A", 60, 0, 1) +
                 reaction("A -> B", "0.8 1/s") + reaction("B -> C", "1.2 1/s") + reaction("C -> A", "0.4 1/s") +
                 reaction("B -> nothing", "0.1 1/s"),
             "2 s", "0.01 s"),
      "C", binomial_law(60, law[6])};
  experiment.voxels = 1;
  experiment.realisations = 2000;
  return experiment;
}

}  // namespace

std::vector<NamedExperiment> walkers() {
  return {{"first-passage", "walkers that leave at the far end of a row of voxels", first_passage},
          {"mean-passage", "how long they live on average", mean_passage},
          {"multinomial-0.1", "diffusion, at 0.1 jumps a molecule and step", [] { return multinomial(0.1); }},
          {"multinomial-3", "diffusion, at 3 jumps a molecule and step", [] { return multinomial(3.0); }},
          {"multinomial-100", "diffusion, at 100 jumps a molecule and step", [] { return multinomial(100.0); }},
          {"first-order", "A -> B -> C -> A while they walk and are lost", first_order}};
}

}  // namespace shmoo::run::verify
