#pragma once
// A body in its present configuration: Hooke's law as a rate, with the spin taken out (Jaumann), density by continuity,
// and an artificial stress against clumping in tension (Gray, Monaghan & Swift 2001, "SPH elastic dynamics", Comput.
// Methods Appl. Mech. Eng. 190, 6641; sph-bvf Eqs. 17-22 with their signs and traces put right):
//
//   dS/dt = 2 G (eps - tr eps/3) + w S - S w,  d rho/dt = -rho tr eps,  sigma = S - K (rho/rho0 - 1),
//   m dv_i/dt = V_i sum_j V_j F_ij [sigma_i A_i p(x_ji) - sigma_j A_j p(x_ij)]
//             - m^2 sum_j F_ij [(W_ij/W(dp))^4 (R_i/rho_i^2 + R_j/rho_j^2) + Pi_ij] x_ij.
//
// eps and w are the symmetric and the skew part of the velocity's gradient, sum_j V_j F_ij (v_j - v_i) (A_i p(x_ji))^T,
// a fit by least squares that is exact for quadratic fields: p are their terms, A_i what makes the fit (Liszka & Orkisz
// 1980, Comput. Struct. 11, 83). With plain or linearly corrected gradients (as in the papers) the outer layers of a
// bent plate see the strain of those further inside, and its first period at ten layers is a tenth too long. Forces are
// the gradient's adjoint, so that elastic energy is what they work. In two dimensions S_zz = -(S_xx + S_yy) is kept and
// K is that of three. R_i takes artificial_stress times each tensile principal stress; Pi is Monaghan's viscosity. Kept
// for comparison: it dissipates, forgets its reference shape, and needs its two artificial terms.
#include "hydro/solid/body.hpp"
#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::hydro {

template <int D>
class HookeJaumann final : public Elasticity<D> {
 public:
  using Vec = base::Vec<D>;
  using Mat = base::Mat<D>;
  static constexpr int terms = D + D * (D + 1) / 2;  // of a quadratic without its constant
  using Terms = Eigen::Matrix<double, terms, 1>;

  HookeJaumann(const Body<D>& body, const base::Box<D>& box, const scene::Elastic& elastic,
               const scene::Numerics& numerics);

  void find_forces(Body<D>& body, double dt) override;
  double step_limit(const Body<D>& body) const override;
  double energy(const Body<D>& body) const override;
  Stress<D> stress(const Body<D>& body, std::size_t particle) const override;
  double density(const Body<D>&, std::size_t particle) const override { return density_[particle]; }

 private:
  void follow(const Body<D>& body);
  template <class Kernel>
  void strain(const Body<D>& body, const Kernel& kernel, double dt);
  template <class Kernel>
  void accelerate(Body<D>& body, const Kernel& kernel) const;
  void set_pull(const Body<D>& body, std::size_t i);
  Terms p(const Vec& x) const;
  Vec apart(std::size_t i, std::size_t j) const { return box_.nearest(position_[i] - position_[j]); }
  double pressure(const Body<D>& body, std::size_t i) const;  // [Pa]

  base::Box<D> box_;
  sph::AnyKernel<D> kernel_;
  double reach_, skin_;                   // [m]
  double artificial_stress_, viscosity_;  // [1]
  sph::NeighbourRows<D> rows_;
  std::vector<Vec> position_, listed_at_;                    // [m]
  std::vector<double> density_, compression_;                // [kg/m^3], [1] its factor in a step
  std::vector<Mat> deviator_;                                // [Pa] S
  std::vector<Eigen::Matrix<double, D, terms>> fit_, pull_;  // A, sigma A; p in units that suit
  std::vector<Mat> repulsion_;                               // [Pa m^6/kg^2] R/rho^2
};

extern template class HookeJaumann<2>;
extern template class HookeJaumann<3>;

}  // namespace shmoo::hydro
