#pragma once
// Jumps, exits and entries of smooth amounts with noise: how much passes in a stage of a Langevin step (langevin.hpp).
#include <span>
#include <vector>

#include "rdme/langevin_reactions.hpp"

namespace shmoo::rdme {

class LangevinTransport {
 public:
  explicit LangevinTransport(const Network& network) : network_(network) {}

  // Throws base::RunError where a rate is negative or not finite.
  void bind(const Voxels& voxels, State& state);

  double fastest() const { return fastest_; }  // [1/s] total rate of leaving of any molecule

  // What passes in h [s] at rates of the amounts `effective`; adds what each amount would lose.
  void draw(double h, const StageAddress& address, std::span<const double> effective, std::span<double> taken);

  // Lets it pass, as far as the share of where it comes from allows, and books exits and entries.
  void apply(std::span<const double> share);

 private:
  // A pair of voxels, the lower id first, and what passes from it to the other.
  struct Pair {
    std::uint32_t low = 0, high = 0, species = 0;
    double up = 0, down = 0;  // [1/s] rates per molecule
    double passes = 0;        // [molecules] in this stage
  };
  struct Gate {
    std::uint32_t voxel = 0, species = 0;
    double exit = 0, entry = 0;     // [1/s] per molecule, [molecules/s]
    double leaves = 0, enters = 0;  // [molecules] in this stage
  };

  void add_pairs(int species);
  void sort_pairs();
  void join_pairs();

  const Network& network_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  std::vector<Pair> pairs_;  // ascending by lower voxel
  std::vector<Gate> gates_;
  double fastest_ = 0;
};

}  // namespace shmoo::rdme
