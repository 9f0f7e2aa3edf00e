#pragma once
// What solid particles show the fluid: velocity and pressure extrapolated from it (Adami, Hu & Adams 2012, "A
// generalized wall boundary condition for smoothed particle hydrodynamics", Eqs. 22-27), the velocity to second order
// behind smooth surfaces (WallFit). Resting materials are walls to a fluid that touches them.
#include <optional>

#include "hydro/state.hpp"
#include "hydro/wall_fit.hpp"
#include "hydro/wall_motion.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

template <int D>
class Walls {
 public:
  using Vec = base::Vec<D>;

  explicit Walls(const scene::Scene& scene) : motion_(scene) {}

  const WallMotion<D>& motion() const { return motion_; }

  // Asks for the column wall_velocity where there are solids, and gives every solid its starting values.
  void prepare(State<D>& state, const scene::Scene& scene);
  // Moves the particles of moving walls from time t to t + dt and renews their velocities.
  void carry(State<D>& state, double t, double dt);
  // At time t: v_w <- 2 v_wall - sum_f v_f W/sum_f W, or by the fit; leaves W_ij in the weights of solid rows. Behind a
  // straining wall only what the fluid's velocity departs from the strain's is mirrored: a fluid that is strained along
  // then meets no jump.
  void extrapolate_velocity(State<D>& state, const sph::AnyKernel<D>& kernel, double t);
  // p_w <- [sum_f p_f W + (f - a_w).sum_f rho_f x_wf W]/sum_f W, with density and volume to match. Uses those weights.
  void extrapolate_pressure(State<D>& state, double t) const;

 private:
  template <class Kernel>
  Vec mirrored(State<D>& state, const Kernel& kernel, double t, std::size_t i) const;
  double pressure_at(const State<D>& state, std::size_t i, const Vec& force) const;  // [Pa]; force [m/s^2] on the fluid

  WallMotion<D> motion_;
  std::optional<WallFit<D>> fit_;  // where walls are of second order
};

extern template class Walls<2>;
extern template class Walls<3>;

}  // namespace shmoo::hydro
