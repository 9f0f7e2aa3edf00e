#pragma once
// Reactions of smooth amounts with noise: how often each happens in a stage of a Langevin step (langevin.hpp).
#include <span>
#include <vector>

#include "base/random.hpp"
#include "rdme/laws.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

// Where a stage finds its random numbers.
struct StageAddress {
  base::RandomKey key;
  std::uint64_t step = 0;
  std::uint32_t stage = 0;
};

// X(m) of langevin.hpp.
inline double smooth_number(double mean, base::RandomSequence& random) {
  return mean > 0 ? mean + std::sqrt(mean) * random.normal() : 0.0;
}

class LangevinReactions {
 public:
  explicit LangevinReactions(const Network& network);

  void bind(const Voxels& voxels, State& state);

  void evaluate(double t);        // rates at what the state holds
  void evaluate_again(double t);  // from now on [2 rate(now) - rate(before)]^+
  double fastest() const;         // [1/s] of the renewals of an amount by reactions

  // How often each happens in h [s]; adds what they would take from each amount.
  void draw(double h, const StageAddress& address, std::span<double> taken);

  // Lets them happen, each as often as the scarcest share of what it takes allows, and books them.
  void apply(std::span<const double> share);

 private:
  double rate(int reaction, std::size_t voxel);
  double number(std::size_t voxel, int species) const;

  const Network& network_;
  Laws laws_;
  const Voxels* voxels_ = nullptr;
  State* state_ = nullptr;
  double time_ = 0;
  std::vector<double> rate_, times_;  // [voxel * reactions + r]
};

}  // namespace shmoo::rdme
