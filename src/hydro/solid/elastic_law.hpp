#pragma once
// Hyperelastic laws: energy psi(F), first Piola-Kirchhoff stress P = d psi/dF and tangent dP/dF of a material point. In
// two dimensions a third stretch, the hoop, stands for what is not in the plane: 1 in plane strain, r/R (times what is
// elastic of it) in axisymmetry. P is per volume of the state in which F = I.
#include <Eigen/LU>

#include "base/vec.hpp"
#include "scene/solid.hpp"

namespace shmoo::hydro {

struct Moduli {
  double shear = 0;  // [Pa] G
  double bulk = 0;   // [Pa] K, of three dimensions: a small strain has the pressure -K tr(strain)
};

// K = 2 G (1 + nu)/(3 (1 - 2 nu)).
Moduli moduli(double shear, double poisson_ratio);

// G = G0 max(least, 1 - coefficient C); K stays. `concentration` [molecules/m^3].
double softened(double shear, const scene::Softening& softening, double concentration);

template <int D>
struct Deformation {
  base::Mat<D> F = base::Mat<D>::Identity();
  double hoop = 1;  // of two dimensions
  double J() const { return D == 2 ? F.determinant() * hoop : F.determinant(); }
};

template <int D>
struct Stress {
  base::Mat<D> P = base::Mat<D>::Zero();  // [Pa]
  double hoop = 0;                        // [Pa] d psi/d hoop, of two dimensions
};

// Entry a + D b of a vector of strains is F_ab; the last one, in two dimensions, the hoop.
template <int D>
inline constexpr int strains = D == 2 ? 5 : D* D;
template <int D>
using Strains = Eigen::Matrix<double, strains<D>, 1>;
template <int D>
using Tangent = Eigen::Matrix<double, strains<D>, strains<D>>;

// Neo-Hookean: psi = G/2 (J^(-2/3) I1 - 3) + K/4 (J^2 - 1 - 2 ln J), I1 = |F|^2 + hoop^2 (Simo & Hughes 1998,
// "Computational Inelasticity", Eq. 9.2.3-9.2.5). Saint Venant-Kirchhoff: psi = G E:E + (K/2 - G/3) (tr E)^2,
// E = (F^T F - I)/2. Both need det F > 0 and throw base::RunError else.
template <int D>
class ElasticPoint {
 public:
  ElasticPoint(scene::ElasticLaw law, const Moduli& moduli, const Deformation<D>& deformation);

  double energy() const;  // [J/m^3]
  Stress<D> stress() const;
  Tangent<D> tangent() const;  // [Pa]

 private:
  Strains<D> first() const;        // d psi, as a vector
  Strains<D> log_volume() const;   // d ln J
  Tangent<D> log_volume2() const;  // d2 ln J
  Tangent<D> neo_hookean_tangent() const;
  Tangent<D> kirchhoff_tangent() const;

  scene::ElasticLaw law_;
  Moduli moduli_;
  Deformation<D> at_;
  base::Mat<D> inverse_;
  double J_, I1_;
};

// Cauchy stress sigma = P F^T/J and the hoop's P_hoop hoop/J [Pa].
template <int D>
Stress<D> cauchy(const Stress<D>& piola, const Deformation<D>& at);

extern template class ElasticPoint<2>;
extern template class ElasticPoint<3>;
extern template Stress<2> cauchy(const Stress<2>&, const Deformation<2>&);
extern template Stress<3> cauchy(const Stress<3>&, const Deformation<3>&);

}  // namespace shmoo::hydro
