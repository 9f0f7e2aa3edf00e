#pragma once
// Velocities that continue the fluid's behind a smooth wall to second order. Around the foot of a wall particle, the
// nearest point of the true surface, the velocity relative to the wall is fitted by kernel-weighted least squares over
// the fluid particles, as G d + Q d^2 in the distance d from the surface (its normal component as G d, which no flow
// without sources exceeds), and continued to the particle's depth. A fit around the particle itself would be singular
// in deep layers, which see one row of fluid only.
#include <vector>

#include "hydro/state.hpp"
#include "hydro/wall_motion.hpp"
#include "sph/cells.hpp"
#include "sph/kernel.hpp"
#include "sph/surface.hpp"

namespace shmoo::hydro {

template <int D>
class WallFit {
 public:
  using Vec = base::Vec<D>;

  // Finds the foot of every solid particle at its starting place. Edges and corners have none. `careful`: neither has
  // what stands nearer to them than the kernel reaches, where velocities may be singular; and what is continued turns
  // into mirrored velocities where the fluid is too fast for its viscosity to shape it over the kernel's reach.
  void prepare(State<D>& state, const sph::Surface<D>& surface, bool careful);
  // Turns what belongs to particle i along with a wall that has moved for dt [s].
  void turn(const WallMotion<D>& motion, std::size_t material, std::size_t i, double dt) {
    (*normal_)[i] = motion.turn(material, (*normal_)[i], dt);
    if (axis_) (*axis_)[i] = motion.turn(material, (*axis_)[i], dt);
  }
  // Turns the mirrored velocities [m/s] that solids have at time t into fitted ones; leaves alone those about whose
  // foot there is too little fluid.
  void apply(State<D>& state, const WallMotion<D>& motion, const sph::AnyKernel<D>& kernel, double t);

 private:
  struct Sums;
  // A place of the surface, what lies behind it and the fluid about it.
  struct Foot {
    std::vector<std::uint32_t> solids, around;  // particles
  };

  double trust(const State<D>& state, double reach, const Sums& sums) const;
  bool fits(std::size_t i) const { return (*normal_)[i] != Vec::Zero(); }
  sph::SurfacePoint<D> point(const State<D>& state, std::size_t i) const {
    return {foot(state, i), (*normal_)[i], (*curvature_)[i], axis_ ? (*axis_)[i] : Vec(Vec::Zero())};
  }
  Vec foot(const State<D>& state, std::size_t i) const {
    return state.particles.position[i] + (*depth_)[i] * (*normal_)[i];
  }
  // Lists the feet and the fluid around them anew where the rows are new.
  void follow(const State<D>& state);
  void list_feet(const State<D>& state);
  void list_around(const State<D>& state, const sph::Cells<D>& cells, Foot& foot) const;
  template <class Kernel>
  Sums moments(const State<D>& state, const WallMotion<D>& motion, const Kernel& kernel, double t, const Foot& foot,
               const sph::SurfacePoint<D>& point) const;

  sph::Column<Vec>* normal_ = nullptr;        // of the surface at the foot, into the fluid; 0 without a foot
  sph::Column<double>* depth_ = nullptr;      // [m] from the foot
  sph::Column<double>* curvature_ = nullptr;  // [1/m], see sph::SurfacePoint
  sph::Column<Vec>* axis_ = nullptr;          // likewise, where there are cylinders or cones
  bool limited_ = false;                      // by the fluid's speed
  std::vector<Foot> feet_;
  std::vector<Vec> near_;       // [m] where the fluid near walls is
  std::uint64_t followed_ = 0;  // builds of the rows
};

extern template class WallFit<2>;
extern template class WallFit<3>;

}  // namespace shmoo::hydro
