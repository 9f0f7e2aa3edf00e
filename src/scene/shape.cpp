#include <cmath>

#include "scene/scene.hpp"

namespace shmoo::scene {
namespace {

struct Contains {
  const Point& point;
  int dimension;

  double distance_squared(const Point& center) const {
    double sum = 0;
    for (int axis = 0; axis < dimension; ++axis) {
      const double difference = point[static_cast<std::size_t>(axis)] - center[static_cast<std::size_t>(axis)];
      sum += difference * difference;
    }
    return sum;
  }

  bool operator()(const BoxShape& box) const {
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis)
      if (point[axis] < box.lower[axis] || point[axis] >= box.upper[axis]) return false;
    return true;
  }

  bool operator()(const BallShape& ball) const { return distance_squared(ball.center) < ball.radius * ball.radius; }

  // A ball of the inner radius and the shell fill the ball of the outer radius without gap or overlap.
  bool operator()(const ShellShape& shell) const {
    const double squared = distance_squared(shell.center);
    return squared >= shell.inner * shell.inner && squared < shell.outer * shell.outer;
  }

  // Half-spaces of opposite normals share no point and leave none out.
  bool operator()(const HalfSpaceShape& half) const {
    double along = 0, first = 0;
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(dimension); ++axis) {
      along += (point[axis] - half.point[axis]) * half.normal[axis];
      if (first == 0) first = half.normal[axis];
    }
    return along < 0 || (along == 0 && first < 0);
  }

  // Even-odd rule by a ray in the direction of +x; edges are half-open in y. In 3-D turned about the x axis.
  bool operator()(const PolygonShape& polygon) const {
    const double y = dimension == 3 ? std::hypot(point[1], point[2]) : point[1];
    bool inside = false;
    const auto& corners = polygon.corners;
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
      const auto& [xi, yi] = corners[i];
      const auto& [xj, yj] = corners[j];
      if ((yi > y) == (yj > y)) continue;
      if (point[0] < xi + (xj - xi) * ((y - yi) / (yj - yi))) inside = !inside;
    }
    return inside;
  }

  bool operator()(const UnionShape& all) const {
    for (const auto& part : all.parts)
      if (contains(*part, point, dimension)) return true;
    return false;
  }

  bool operator()(const DifferenceShape& difference) const {
    return contains(*difference.from, point, dimension) && !contains(*difference.without, point, dimension);
  }
};

}  // namespace

bool contains(const Shape& shape, const Point& point, int dimension) {
  return std::visit(Contains{point, dimension}, shape.form);
}

}  // namespace shmoo::scene
