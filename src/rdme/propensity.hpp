#pragma once
// Propensities of sampled reactions (the law is in network.hpp). Holds compiled expressions: one object per sampler and
// thread.
#include <cstdint>
#include <vector>

#include "rdme/laws.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"
#include "rdme/voxels.hpp"

namespace shmoo::rdme {

class Propensities {
 public:
  explicit Propensities(const Network& network);

  // References must outlive it, and stay of the same size.
  void bind(const Voxels& voxels, const State& state);

  void set_time(double t);  // [s]; expressions are evaluated there

  // Events per second of a reaction in a voxel, at the numbers that the state holds now. Throws base::RunError, naming
  // the reaction, the voxel and the time, where the value is negative, infinite or not a number.
  double operator()(int reaction, std::size_t voxel) {
    const Law& law = laws_.of_reaction[reaction];
    if (law.expression >= 0) return evaluate(reaction, voxel);
    double a = law.constant * available(law, voxel);
    if (law.order != 1) a *= volume_factor(law.order, volume_[voxel], inverse_volume_[voxel]);
    if (!(a >= 0.0 && a <= 1e300)) refuse(reaction, voxel, a);
    return a;
  }

 private:
  // prod n (n-1) ... (n-nu+1) over stochastic reactants, times prod n^nu over deterministic ones; zero where short of
  // any.
  double available(const Law& law, std::size_t voxel) const {
    double product = 1.0;
    for (std::uint32_t f = law.first; f < law.last; ++f) {
      const Factor& factor = laws_.factors[f];
      const std::size_t at = voxel * species_ + factor.species;
      if (factor.stochastic) {
        product *= falling(count_[at], factor.count);
      } else {
        const double n = amount_[at] > 0.0 ? amount_[at] : 0.0;
        if (n < factor.taken) return 0.0;
        for (int k = 0; k < factor.count; ++k) product *= n;
      }
    }
    return product;
  }

  double evaluate(int reaction, std::size_t voxel);
  [[noreturn]] void refuse(int reaction, std::size_t voxel, double value) const;

  const Network& network_;
  Laws laws_;
  std::size_t species_ = 0;
  const std::int64_t* count_ = nullptr;
  const double* amount_ = nullptr;
  const double* volume_ = nullptr;
  const Voxels* voxels_ = nullptr;
  std::vector<double> inverse_volume_;
  double time_ = 0;
};

}  // namespace shmoo::rdme
