#pragma once
// A network on a lattice, ready to run, and how what was computed is checked.
#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "rdme/state.hpp"
#include "rdme/voxels.hpp"
#include "scene/scene.hpp"

namespace shmoo::run::bench {

// Numbers of molecules, voxel-major, with what they are numbers of.
struct Numbers {
  std::vector<double> n;
  std::size_t species = 1;
  std::size_t voxels() const { return n.size() / species; }
  double total(std::size_t s) const;
};
Numbers counts_of(const rdme::State& state);
Numbers amounts_of(const rdme::State& state);

// (Sum over voxels and species of (n - mean)^2/mean - degrees)/sqrt(2 degrees): standard normal where numbers are
// multinomial over the voxels given their total, species by species.
double spread_over_voxels(const Numbers& numbers);

struct Problem {
  std::string name;
  scene::Scene scene;
  std::array<std::uint32_t, 3> cells{1, 1, 1};
  double mean = 10;                                  // molecules of each species and voxel at the start
  double events_per_second = 0;                      // about, of all voxels
  std::string law;                                   // of numbers that stay at equilibrium, and
  std::function<double(const Numbers&)> deviations;  // standard normal where it holds
  // Without noise: where to start, for how long to run [s], and how far from what is known one then is (relative).
  std::function<void(Numbers&)> start;
  double until = 1.0;
  std::string smooth_law;
  std::function<double(const Numbers&)> error;

  double voxels() const { return double(cells[0]) * cells[1] * cells[2]; }
};

Problem diffusion_problem(std::uint32_t n);                  // D3-n
Problem binding_problem(std::uint32_t n, double mean = 10);  // RD-n, or the same with more molecules
Problem ring_problem(int species);
Problem dimer_problem();

}  // namespace shmoo::run::bench
