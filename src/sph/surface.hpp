#pragma once
// Where fluid ends: the surface that the regions and the sides of a scene leave between fluid and all else. Every
// smooth piece of it is plane or spherical, so a point of it knows by its normal and its curvature the distances all
// around.
#include <optional>
#include <vector>

#include "base/box.hpp"
#include "scene/scene.hpp"

namespace shmoo::sph {

template <int D>
struct SurfacePoint {
  using Vec = base::Vec<D>;

  Vec place;             // [m]
  Vec normal;            // out of the solid, into the fluid
  double curvature = 0;  // [1/m] 1/radius where the solid is inside the sphere, -1/radius where the fluid is

  // Of the piece's plane or sphere at a point `from` [m] away from here: the signed distance [m], and the normal there.
  double distance(const Vec& from) const {
    const Vec turned = normal + curvature * from;
    return (2.0 * from.dot(normal) + curvature * from.squaredNorm()) / (1.0 + turned.norm());
  }
  Vec normal_at(const Vec& from) const { return (normal + curvature * from).normalized(); }
};

template <int D>
class Surface {
 public:
  using Vec = base::Vec<D>;

  explicit Surface(const scene::Scene& scene);

  // The point of the surface nearest to a place in the solid, none where it is further than `within` [m] away or is an
  // edge or corner, which has no normal.
  std::optional<SurfacePoint<D>> nearest(const Vec& x, double within) const;

  // Whether the surface goes on about a point of it, all the way to `within` [m], as the plane or sphere that it is
  // there; corners of a tenth of a spacing are let pass.
  bool smooth_about(const SurfacePoint<D>& point, double within) const;

  bool fluid_at(const Vec& x) const;

 private:
  void list_sides();
  bool adjust(const Vec& x, SurfacePoint<D>& point) const;

  const scene::Scene& scene_;
  base::Box<D> box_;
  double probe_;                        // [m] how far off the surface it is asked what is there
  std::vector<SurfacePoint<D>> sides_;  // planes beyond which the domain ends
};

extern template class Surface<2>;
extern template class Surface<3>;

}  // namespace shmoo::sph
