#include "sph/surface_pieces.hpp"

#include <cmath>

namespace shmoo::sph {
namespace {

using base::Vec;

template <int D>
Vec<D> vector_of(const scene::Point& point) {
  Vec<D> v;
  for (int a = 0; a < D; ++a) v[a] = point[std::size_t(a)];
  return v;
}

template <int D>
struct EachFoot {
  const Vec<D>& x;
  const std::function<void(const SurfacePoint<D>&)>& offer;

  // A sphere around a center, whose inside belongs to the shape or not.
  void sphere(const Vec<D>& center, double radius, bool outward) const {
    const Vec<D> r = x - center;
    const double distance = r.norm();
    if (!(distance > 1e-9 * radius) || radius == 0.0) return;
    const Vec<D> e = r / distance;
    offer({center + radius * e, outward ? e : Vec<D>(-e), (outward ? 1.0 : -1.0) / radius});
  }

  void operator()(const scene::BallShape& ball) const { sphere(vector_of<D>(ball.center), ball.radius, true); }

  void operator()(const scene::ShellShape& shell) const {
    sphere(vector_of<D>(shell.center), shell.outer, true);
    sphere(vector_of<D>(shell.center), shell.inner, false);
  }

  void operator()(const scene::HalfSpaceShape& half) const {
    const Vec<D> n = vector_of<D>(half.normal).normalized();
    offer({x - (x - vector_of<D>(half.point)).dot(n) * n, n, 0.0});
  }

  void operator()(const scene::BoxShape& box) const {
    const Vec<D> lower = vector_of<D>(box.lower), upper = vector_of<D>(box.upper);
    for (int a = 0; a < D; ++a) {
      bool beside = true;
      for (int b = 0; b < D; ++b) beside = beside && (b == a || (x[b] >= lower[b] && x[b] <= upper[b]));
      if (!beside) continue;
      for (const double sign : {-1.0, 1.0}) {
        SurfacePoint<D> point{x, Vec<D>::Zero(), 0.0};
        point.place[a] = sign < 0.0 ? lower[a] : upper[a];
        point.normal[a] = sign;
        offer(point);
      }
    }
  }

  // Calls visit(place, normal) for the feet of x on the edges of a polygon, leaving out those of edges on the x axis.
  static void feet_on_edges(const scene::PolygonShape& polygon, const Vec<2>& x, bool turned, const auto& visit) {
    const auto& corners = polygon.corners;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
      if (turned && corners[i][1] == 0.0 && corners[j][1] == 0.0) continue;
      const Vec<2> from(corners[j][0], corners[j][1]), along = Vec<2>(corners[i][0], corners[i][1]) - from;
      const double part = (x - from).dot(along) / along.squaredNorm();
      if (!(part >= 0.0 && part <= 1.0)) continue;
      visit(Vec<2>(from + part * along), Vec<2>(Vec<2>(along[1], -along[0]).normalized()));
    }
  }

  // In 3-D turned about the x axis. Its pieces are cones, shown by cylinders that touch them along a line, and discs.
  void operator()(const scene::PolygonShape& polygon) const {
    if constexpr (D == 2)
      feet_on_edges(polygon, x, false, [&](const Vec<2>& foot, const Vec<2>& normal) { offer({foot, normal, 0.0}); });
    if constexpr (D == 3) {
      const double r = std::hypot(x[1], x[2]);
      const Vec<3> out = r > 0.0 ? Vec<3>(0.0, x[1] / r, x[2] / r) : Vec<3>(Vec<3>::UnitY());
      feet_on_edges(polygon, {x[0], r}, true, [&](const Vec<2>& foot, const Vec<2>& normal) {
        const auto in_space = [&](double along, double away) { return Vec<3>(along * Vec<3>::UnitX() + away * out); };
        SurfacePoint<3> point{in_space(foot[0], foot[1]), in_space(normal[0], normal[1])};
        if (normal[1] != 0.0 && foot[1] > 0.0) {
          point.curvature = normal[1] / foot[1];
          point.axis = in_space(normal[1], -normal[0]);
        }
        offer(point);
      });
    }
  }

  void operator()(const scene::UnionShape& all) const {
    for (const auto& part : all.parts) each_foot<D>(*part, x, offer);
  }

  void operator()(const scene::DifferenceShape& difference) const {
    each_foot<D>(*difference.from, x, offer);
    each_foot<D>(*difference.without, x, offer);
  }
};

}  // namespace

template <int D>
void each_foot(const scene::Shape& shape, const Vec<D>& x, const std::function<void(const SurfacePoint<D>&)>& offer) {
  std::visit(EachFoot<D>{x, offer}, shape.form);
}

template void each_foot<1>(const scene::Shape&, const Vec<1>&, const std::function<void(const SurfacePoint<1>&)>&);
template void each_foot<2>(const scene::Shape&, const Vec<2>&, const std::function<void(const SurfacePoint<2>&)>&);
template void each_foot<3>(const scene::Shape&, const Vec<3>&, const std::function<void(const SurfacePoint<3>&)>&);

}  // namespace shmoo::sph
