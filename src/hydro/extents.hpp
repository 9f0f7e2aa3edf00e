#pragma once
// The box of a scene, axis by axis, as a flow sees it.
#include "base/vec.hpp"
#include "scene/scene.hpp"

namespace shmoo::hydro {

template <int D>
base::Vec<D> vector_of(const scene::Point& point) {
  base::Vec<D> v;
  for (int a = 0; a < D; ++a) v[a] = point[a];
  return v;
}

inline bool is_periodic(const scene::Scene& scene, int axis) {
  return scene.domain.sides[std::size_t(axis)][0].type == scene::SideType::periodic;
}

inline bool has_friction(const scene::Scene& scene, int axis) {
  const auto& sides = scene.domain.sides[std::size_t(axis)];
  return scene::has_friction(sides[0].type) || scene::has_friction(sides[1].type);
}

// Whether fluid leaves at one end and enters at the other.
inline bool passes(const scene::Scene& scene, int axis) {
  const auto& sides = scene.domain.sides[std::size_t(axis)];
  return is_periodic(scene, axis) || (scene::is_open(sides[0].type) && scene::is_open(sides[1].type));
}

inline double extent(const scene::Scene& scene, int axis) {
  return scene.domain.upper[std::size_t(axis)] - scene.domain.lower[std::size_t(axis)];
}

}  // namespace shmoo::hydro
