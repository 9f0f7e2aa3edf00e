#pragma once
// The plane, spherical, cylindrical and conical pieces of which the boundary of a shape is made.
#include <functional>

#include "scene/scene.hpp"
#include "sph/surface.hpp"

namespace shmoo::sph {

// Calls offer(point) with the foot of x on every piece of the shape's boundary, where x has one; the normal points out
// of the shape. Parts of a union or a difference may hide it.
template <int D>
void each_foot(const scene::Shape& shape, const base::Vec<D>& x,
               const std::function<void(const SurfacePoint<D>&)>& offer);

}  // namespace shmoo::sph
