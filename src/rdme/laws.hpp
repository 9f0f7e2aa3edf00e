#pragma once
// Rate laws of a network in a flat form for fast evaluation, with their compiled expressions. Not thread safe: one per
// sampler or solver and thread.
#include <cstdint>
#include <vector>

#include "rdme/expression.hpp"
#include "rdme/network.hpp"
#include "rdme/time/timed_rate.hpp"

namespace shmoo::rdme {

struct Factor {
  int species = 0, count = 0;
  bool stochastic = false;
  int taken = 0;        // whole molecules that one event takes on balance
  bool beyond = false;  // in the other voxel of a reaction on a surface
};

struct Law {
  double constant = 0;                // k
  int order = 0;                      // m
  int own_order = 0;                  // on a surface: of the first voxel alone
  std::uint32_t first = 0, last = 0;  // factors
  int expression = -1;                // index; -1: mass action
  bool surface = false;
  bool simple = true;  // mass action in one voxel
  int timed = -1;      // index where the rate contains t
};

struct Laws {
  Laws(const Network& network, Treatment of);  // with the expressions of reactions that are treated so

  // The present values of the parameters that events change.
  void set_parameters(const Network& network, const double* values);

  std::vector<Law> of_reaction;
  std::vector<Factor> factors;
  std::vector<Expression> expressions;
  std::vector<TimedRate> timed;
};

// V^(1-m), by the inverse volume [1/m^3].
inline double volume_factor(int order, double volume, double inverse_volume) {
  if (order == 0) return volume;
  double factor = 1.0;
  for (int m = 1; m < order; ++m) factor *= inverse_volume;
  return factor;
}

// n (n-1) ... (n-count+1), count >= 1
inline double falling(std::int64_t n, int count) {
  double product = static_cast<double>(n);
  for (int k = 1; k < count; ++k) product *= static_cast<double>(n - k);
  return product;
}

}  // namespace shmoo::rdme
