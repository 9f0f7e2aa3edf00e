#pragma once
// A body in its present configuration: Hooke's law as a rate, with the spin taken out (Jaumann), density by continuity,
// and an artificial stress against clumping in tension (Gray, Monaghan & Swift 2001, "SPH elastic dynamics", Comput.
// Methods Appl. Mech. Eng. 190, 6641; sph-bvf Eqs. 17-22 with their signs and traces put right):
//
//   dS/dt = 2 G (eps - tr eps/3) + w S - S w,  d rho/dt = -rho tr eps,  sigma = S - K (rho/rho0 - 1),
//   dv_i/dt = sum_j m_j [sigma_i B_i/rho_i^2 + sigma_j B_j/rho_j^2 + (W_ij/W(dp))^4 (R_i + R_j) - Pi_ij] grad_i W_ij.
//
// eps and w are the symmetric and the skew part of the velocity's gradient, here with corrected kernel gradients, so
// that a turning body is not strained. In two dimensions S_zz = -(S_xx + S_yy) is kept and K is that of three. R_i
// takes artificial_stress times each tensile principal stress; Pi is Monaghan's viscosity. Kept for comparison: it
// dissipates, forgets its reference shape, and needs its two artificial terms.
#include "hydro/solid/body.hpp"
#include "sph/kernel.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::hydro {

template <int D>
class HookeJaumann final : public Elasticity<D> {
 public:
  using Vec = base::Vec<D>;
  using Mat = base::Mat<D>;

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
  Vec apart(std::size_t i, std::size_t j) const { return box_.nearest(position_[i] - position_[j]); }
  double pressure(const Body<D>& body, std::size_t i) const;  // [Pa]

  base::Box<D> box_;
  sph::AnyKernel<D> kernel_;
  double reach_, skin_;                   // [m]
  double artificial_stress_, viscosity_;  // [1]
  sph::NeighbourRows<D> rows_;
  std::vector<Vec> position_, listed_at_;      // [m]
  std::vector<double> density_, compression_;  // [kg/m^3], [1] its factor in a step
  std::vector<Mat> deviator_;                  // [Pa] S
  std::vector<Mat> correction_;                // [1] B of the kernel's gradient
  std::vector<Mat> pull_, repulsion_;          // [Pa m^6/kg^2] sigma B/rho^2, R
};

extern template class HookeJaumann<2>;
extern template class HookeJaumann<3>;

}  // namespace shmoo::hydro
