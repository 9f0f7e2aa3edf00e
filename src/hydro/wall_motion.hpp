#pragma once
// How solid materials move: motions, rigid or straining along the axes, that carry particles along, and surfaces that
// slide while their particles stay. The centre of a rotation or strain travels with the motion's velocity.
#include <algorithm>
#include <limits>
#include <vector>

#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace shmoo::hydro {

template <int D>
class WallMotion {
 public:
  using Vec = base::Vec<D>;

  explicit WallMotion(const scene::Scene& scene);

  bool any_moves() const { return any_moves_; }
  bool moves(std::size_t material) const { return entries_[material].moves; }

  // Velocity [m/s] of a surface of this material at x and time t [s]: that of its particles plus what slides.
  Vec surface_velocity(std::size_t material, const Vec& x, double t) const;
  // Acceleration [m/s^2] of a particle carried along at x.
  Vec acceleration(std::size_t material, const Vec& x, double t) const;
  // How much faster [m/s] a wall of this material moves at one point than at another, r [m] from there, for it turns.
  Vec turning(std::size_t material, const Vec& r) const {
    return entries_[material].motion.spin_cross(r) + entries_[material].surface.spin_cross(r);
  }
  // Whether a surface of this material has a velocity at all.
  bool slides(std::size_t material) const { return entries_[material].slides; }
  bool strains(std::size_t material) const { return entries_[material].motion.strain != Vec::Zero(); }
  // How much of dt from time t on the motion of this material lasts.
  double moving(std::size_t material, double t, double dt) const {
    return std::clamp(entries_[material].motion.until - t, 0.0, dt);
  }
  // A normal of the material, after it has moved for dt.
  Vec turn(std::size_t material, const Vec& direction, double dt) const;
  // What the motion of this material turns round, at time t.
  Vec center(std::size_t material, double t) const {
    return entries_[material].motion.center + moving(material, 0.0, t) * entries_[material].motion.velocity;
  }
  // Where at time 0 the point of the material was that at time t stands `offset` from the center.
  Vec home(std::size_t material, const Vec& offset, double t) const {
    return entries_[material].motion.center + entries_[material].motion.carried(offset, -moving(material, 0.0, t));
  }
  // Where a particle at x and time t is carried in dt.
  Vec carry(std::size_t material, const Vec& x, double t, double dt) const;

 private:
  struct Rigid {
    Vec velocity = Vec::Zero(), center = Vec::Zero(), strain = Vec::Zero();
    double until = std::numeric_limits<double>::infinity();
    base::Vec<3> spin = base::Vec<3>::Zero();
    Vec at(const Vec& x, double t) const;  // velocity
    Vec spin_cross(const Vec& r) const;
    Vec turned(const Vec& r, double dt) const;
    Vec carried(const Vec& r, double dt) const;  // from the center
    bool any() const { return velocity != Vec::Zero() || spin != base::Vec<3>::Zero() || strain != Vec::Zero(); }
  };
  struct Entry {
    bool moves = false, slides = false;
    Rigid motion, surface;
  };
  static Rigid rigid(const scene::RigidMotion& motion);

  std::vector<Entry> entries_;  // by material, side materials included
  bool any_moves_ = false;
};

// A surface's velocity near one of its points: linear in the way from there.
template <int D>
struct SurfaceSpeeds {
  using Vec = base::Vec<D>;

  Vec at = Vec::Zero();                       // [m/s]
  base::Mat<D> slope = base::Mat<D>::Zero();  // [1/s]

  SurfaceSpeeds(const WallMotion<D>& motion, std::size_t material, const Vec& place, double t) {
    if (!motion.slides(material)) return;
    at = motion.surface_velocity(material, place, t);
    for (int k = 0; k < D; ++k) slope.col(k) = motion.surface_velocity(material, place + Vec::Unit(k), t) - at;
  }
};

extern template class WallMotion<2>;
extern template class WallMotion<3>;

}  // namespace shmoo::hydro
