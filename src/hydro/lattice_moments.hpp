#pragma once
// Sums over the lattice on which particles start.
#include <cmath>

#include "hydro/scales.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// sum_j term(kernel, r_ij), the particle itself included.
template <int D, class Term>
double lattice_sum(const scene::Scene& scene, const Scales<D>& scales, const Term& term) {
  const auto kernel = sph::make_kernel<D>(scene.numerics.kernel, scales.reach);
  const int most = int(std::ceil(scene.numerics.reach)), depth = D == 3 ? most : 0;
  double sum = 0.0;
  for (int k = -depth; k <= depth; ++k) {
    for (int j = -most; j <= most; ++j) {
      for (int i = -most; i <= most; ++i) {
        const double r = scales.spacing * std::sqrt(double(i * i + j * j + k * k));
        sum += std::visit([&](const auto& each) { return term(each, r); }, kernel);
      }
    }
  }
  return sum;
}

// sum_j F_ij r_ij^power over the others [m^(power - D - 2)].
template <int D>
double lattice_sum_F(const scene::Scene& scene, const Scales<D>& scales, int power) {
  return lattice_sum(scene, scales,
                     [&](const auto& kernel, double r) { return r > 0.0 ? kernel.F(r) * std::pow(r, power) : 0.0; });
}

// sum_j V_j F_ij r_ij^power over the others [m^(power - 2)].
template <int D>
double lattice_moment(const scene::Scene& scene, const Scales<D>& scales, int power) {
  return lattice_sum_F(scene, scales, power) * std::pow(scales.spacing, D);
}

}  // namespace shmoo::hydro
