#pragma once
// How long the propensities of a voxel stay nearly what they are, and which reactions must not leap (Cao, Gillespie &
// Petzold 2006, J. Chem. Phys. 124, 044109).
//
// With mu_s = sum_r nu_rs a_r and sigma_s^2 = sum_r nu_rs^2 a_r over the reactions that leap, the longest leap is
//   tau = min_s { max(epsilon n_s/g_s, 1)/|mu_s|, max(epsilon n_s/g_s, 1)^2/sigma_s^2 }                      (Eq. 33)
// over the species that propensities read; then no propensity changes by more than about epsilon of itself. A reaction
// of order m that takes nu of s asks for g_s = (m/nu) sum_{k < nu} n_s/(n_s - k), which is each case of section III in
// one formula. A custom law asks for g_s = 4, the steepness of a Hill function of exponent 4.
//
// A reaction is critical, and does not leap, where one of its reactants lasts for fewer than ten of its events.
#include <cstdint>
#include <span>
#include <vector>

#include "rdme/network.hpp"
#include "rdme/state.hpp"

namespace shmoo::rdme {

class LeapCondition {
 public:
  // `tolerance`: epsilon, in (0, 1). The network must outlive it.
  LeapCondition(const Network& network, double tolerance);

  // Must this reaction be sampled event by event in this voxel?
  bool critical(int reaction, const State& state, std::size_t voxel) const;

  // The longest leap [s] of the reactions `leaping` with propensities `rate` [1/s], by reaction; infinite where nothing
  // limits it.
  double longest(std::span<const int> leaping, std::span<const double> rate, const State& state, std::size_t voxel);

 private:
  struct Reader {
    int order = 0, count = 0;
    double g(double n) const;
  };
  double number(const State& state, std::size_t voxel, int species) const;

  const Network& network_;
  double tolerance_;
  std::vector<std::vector<Reader>> readers_;  // by species: distinct ways in which sampled propensities read it
  std::vector<double> drift_, spread_;        // mu, sigma^2 by species
};

}  // namespace shmoo::rdme
