#pragma once
// What a splitting step costs in accuracy, seen on a deterministic twin: the well, or two voxels of the scene's size,
// between which species that move are exchanged at the rate of neighbours on the lattice, and from which they start at
// the reference concentrations, every other one on the other side. There the parts that the scene takes in turns are
// taken in turns, each integrated on its own, with a step and with its half; Richardson's extrapolation tells the error
// of the step.
#include <memory>
#include <vector>

#include "rdme/deterministic.hpp"
#include "rdme/network.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

class SplittingTwin {
 public:
  // `reference` [molecules/m^3] by species. The network is that of the scene; both must outlive the twin.
  SplittingTwin(const scene::Scene& scene, const rdme::Network& network, const std::vector<double>& reference);

  int order() const;  // of the splitting error, in the step

  // Amounts, relative to those of reference, after an eighth, a quarter, a half and the whole of `horizon` [s] in so
  // many steps, a multiple of eight.
  std::vector<double> amounts(double horizon, int steps);

 private:
  struct Part {
    std::unique_ptr<rdme::Network> network;
    std::unique_ptr<rdme::DeterministicSolver> solver;
    std::unique_ptr<rdme::DeterministicSolver> diffusion;  // where it takes turns with reactions
  };

  void add_part(rdme::Treatment treatment, const rdme::Network& network);
  void make_voxels(const rdme::Network& network);
  void make_well(const rdme::Network& network);
  void start();
  void step(double t, double h);
  static void advance(Part& part, double t, double h);

  scene::Scene smooth_;  // all species deterministic
  const scene::Scene& scene_;
  std::vector<double> reference_;  // [molecules] in a voxel
  rdme::Voxels voxels_;
  rdme::State state_;
  std::vector<Part> parts_;  // in the order of Chemistry::advance
};

}  // namespace shmoo::coupling
