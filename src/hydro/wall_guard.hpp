#pragma once
// Nothing passes a rigid wall: the way that a fluid particle has gone in a step, seen from each wall as that moves, is
// held against the wall's own shape (its regions, or the side of the domain), not against its particles. Where it runs
// into the wall the particle goes back along its way, and its velocity relative to the wall is reversed (bounce-back of
// the sph-bvf method, found by a swept test in place of a volume fraction: so it holds for walls of any thinness and
// curvature, for several hits in one corner, and however particles are squeezed together). Where only the shift of the
// transport velocity leads into the wall it is not made: it is no motion of the fluid. Elastic solids have no such
// shape; BounceBack guards them.
#include <cstdint>
#include <vector>

#include "hydro/state.hpp"
#include "hydro/wall_motion.hpp"

namespace shmoo::hydro {

template <int D>
class WallGuard {
 public:
  using Vec = base::Vec<D>;

  explicit WallGuard(const scene::Scene& scene);

  // After fluid and walls have gone on from t - dt to t [s]: turns back what has run into a wall; returns how many.
  std::uint64_t apply(State<D>& state, const WallMotion<D>& motion, double t, double dt) const;

 private:
  // What stands still together: all resting walls and sides, or one wall that moves.
  static constexpr int nothing = -1, resting = -2;
  struct Way {
    Vec from, to;  // [m] as the frame saw it at its start
  };
  struct Hit {
    int material = nothing;        // of what was hit, sides as in sph::side_material
    Vec place, end = Vec::Zero();  // [m] of the hit, just before the wall; where the way ends in place of way.to
    Vec normal = Vec::Zero();      // out of the wall; 0 at an edge
  };

  int material_at(const Vec& x) const;
  int wall_at(const Vec& x, int frame) const;  // the material, or nothing
  int side_beyond(const Vec& x) const;
  Way seen_from(int frame, const WallMotion<D>& motion, const Vec& x, const Vec& path, double t, double dt) const;
  Hit meet(const Way& way, int frame) const;
  Hit find(const Way& way, int frame) const;
  Hit hold(const Way& way, int frame) const;
  std::pair<Vec, Vec> nearest_normal(const Vec& x, double within) const;
  bool guard(State<D>& state, const WallMotion<D>& motion, std::size_t i, double t, double dt) const;
  void turn_back(State<D>& state, const WallMotion<D>& motion, std::size_t i, const Hit& hit, int frame,
                 double t) const;
  bool touches(const State<D>& state, std::size_t i) const;

  base::Box<D> box_;
  double spacing_ = 0;
  int domain_material_ = nothing;
  std::vector<scene::Region> regions_;
  std::vector<char> is_wall_, moves_;            // by material
  std::array<std::array<char, 2>, D> closed_{};  // sides that nothing passes
  std::array<char, 2 * D> slips_{};              // those of them without friction
  std::vector<int> frames_;
};

extern template class WallGuard<2>;
extern template class WallGuard<3>;

}  // namespace shmoo::hydro
