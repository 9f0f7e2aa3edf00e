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

  // Finds the foot of every solid particle at its starting place. Edges and corners have none; with `away_from_edges`
  // neither has what stands nearer to them than the kernel reaches, where velocities may be singular.
  void prepare(State<D>& state, const sph::Surface<D>& surface, bool away_from_edges);
  // Turns what belongs to particle i along with a wall that has moved for dt [s].
  void turn(const WallMotion<D>& motion, std::size_t material, std::size_t i, double dt) {
    (*normal_)[i] = motion.turn(material, (*normal_)[i], dt);
  }
  // Lists the fluid around the feet anew where the rows are new.
  void follow(const State<D>& state);

  bool fits(std::size_t i) const { return (*normal_)[i] != Vec::Zero(); }
  // The velocity [m/s] of solid[n]; `wall` is the surface's own. False where too little fluid is about the foot.
  template <class Kernel>
  bool velocity(const State<D>& state, const WallMotion<D>& motion, const Kernel& kernel, double t, std::size_t n,
                Vec& result) const;

 private:
  struct Sums;
  Vec foot(const State<D>& state, std::size_t i) const {
    return state.particles.position[i] + (*depth_)[i] * (*normal_)[i];
  }
  void list_around(const State<D>& state, const sph::Cells<D>& cells, std::size_t n);

  sph::Column<Vec>* normal_ = nullptr;              // of the surface at the foot, into the fluid; 0 without a foot
  sph::Column<double>* depth_ = nullptr;            // [m] from the foot
  sph::Column<double>* curvature_ = nullptr;        // [1/m], see sph::SurfacePoint
  std::vector<std::vector<std::uint32_t>> around_;  // by place in rows.solid(): fluid particles about the foot
  std::vector<Vec> near_;                           // [m] where the fluid near walls is
  std::uint64_t followed_ = 0;                      // builds of the rows
};

extern template class WallFit<2>;
extern template class WallFit<3>;

}  // namespace shmoo::hydro
