#pragma once
// Where fluid, or a set of materials, ends: the surface that the regions and the sides of a scene leave between it and
// all else. Every smooth piece of it is plane, spherical or, about a point, a cylinder, so a point of it knows by its
// normal, its curvature and the axis along which it is straight the distances all around.
#include <optional>
#include <vector>

#include "base/box.hpp"
#include "scene/scene.hpp"

namespace shmoo::sph {

template <int D>
struct SurfacePoint {
  using Vec = base::Vec<D>;

  Vec place;   // [m]
  Vec normal;  // out of the solid, into the fluid
  double curvature =
      0;  // [1/m] 1/radius where the solid is inside the sphere or cylinder, -1/radius where the fluid is
  Vec axis = Vec::Zero();  // unit vector along which a cylinder or cone goes on straight; 0: a plane or sphere

  // Of the piece's plane, sphere or cylinder at a point `from` [m] away from here: the signed distance [m], and the
  // normal there.
  double distance(const Vec& from) const {
    const Vec across = from - from.dot(axis) * axis, turned = normal + curvature * across;
    return (2.0 * from.dot(normal) + curvature * across.squaredNorm()) / (1.0 + turned.norm());
  }
  Vec normal_at(const Vec& from) const { return (normal + curvature * (from - from.dot(axis) * axis)).normalized(); }
  // At such a distance, the solution of Laplace's equation that is 0 on the piece and rises there by 1 per length: the
  // distance itself at a plane, r ln(1 + d/r) at a cylinder, d/(1 + d/r) at a ball.
  double harmonic(double distance) const;
};

template <int D>
class Surface {
 public:
  using Vec = base::Vec<D>;

  explicit Surface(const scene::Scene& scene);  // of the fluid
  Surface(const scene::Scene& scene, std::vector<bool> materials);

  // The point of the surface nearest to a place in the solid, none where it is further than `within` [m] away or is an
  // edge or corner, which has no normal.
  std::optional<SurfacePoint<D>> nearest(const Vec& x, double within) const { return nearest(x, within, false); }
  // The same for a place in the fluid.
  std::optional<SurfacePoint<D>> nearest_from_fluid(const Vec& x, double within) const {
    return nearest(x, within, true);
  }

  // Whether the surface goes on about a point of it, all the way to `within` [m], as the plane or sphere that it is
  // there; corners of a tenth of a spacing are let pass.
  bool smooth_about(const SurfacePoint<D>& point, double within) const;

  bool fluid_at(const Vec& x) const;
  int material_at(const Vec& x) const;  // -1: nothing, or beyond a side

 private:
  void list_sides();
  std::optional<SurfacePoint<D>> nearest(const Vec& x, double within, bool from_fluid) const;
  bool adjust(const Vec& x, bool from_fluid, SurfacePoint<D>& point) const;

  const scene::Scene& scene_;
  base::Box<D> box_;
  std::vector<bool> flows_;             // by material
  double probe_;                        // [m] how far off the surface it is asked what is there
  std::vector<SurfacePoint<D>> sides_;  // planes beyond which the domain ends
};

extern template struct SurfacePoint<1>;
extern template struct SurfacePoint<2>;
extern template struct SurfacePoint<3>;
extern template class Surface<1>;
extern template class Surface<2>;
extern template class Surface<3>;

}  // namespace shmoo::sph
