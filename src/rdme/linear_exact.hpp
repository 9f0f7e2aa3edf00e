#pragma once
// The smallest change of symmetric pair weights a_ij that makes linear functions exact: sum_j a_ij d_ij = 0 along every
// free axis of every particle, d_ij the step from i to j. With Lagrange multipliers mu_i the weights become a_ij (1 +
// (mu_i - mu_j).d_ij), which keeps them symmetric; mu solves a sparse symmetric system. On a lattice nothing changes.
// This is what makes diffusion on disordered particles converge: the plain weights have a first moment of order one.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.hpp"

namespace shmoo::rdme {

template <int D>
struct PairWeights {
  std::vector<std::uint64_t> first;       // [particles + 1]
  std::vector<std::uint32_t> target;      // [pairs]
  std::vector<double> weight;             // [pairs] a_ij = a_ji
  std::vector<base::Vec<D>> step;         // [m] [pairs] d_ij = -d_ji along axes that are free in both
  std::vector<std::array<bool, D>> free;  // [particles] axes along which linear functions shall be exact
};

// The factor of each pair, between 0.05 and 20 so that weights stay positive. Throws base::RunError where the conjugate
// gradients fail.
template <int D>
std::vector<double> linear_exact_factors(const PairWeights<D>& pairs);

extern template std::vector<double> linear_exact_factors(const PairWeights<1>&);
extern template std::vector<double> linear_exact_factors(const PairWeights<2>&);
extern template std::vector<double> linear_exact_factors(const PairWeights<3>&);

}  // namespace shmoo::rdme
