#pragma once
// The shape of a shell's outer surface, told by points from tip to back whose mirror images close it.
#include <vector>

#include "base/vec.hpp"

namespace shmoo::hydro {

using Points = std::vector<base::Vec<2>>;

// [m] from tip to back along the axis, each end by the parabola x(y^2) through its two nearest points.
double length_along_axis(const Points& outline);

// [m] from the tip along the outline, by point.
std::vector<double> arc_length(const Points& outline);

// [1/m] signed, positive where convex: x(s) and y(s) by least squares, quadratic in s, of the points within `window`
// [m] of arc around point k, at least two on each side.
double curvature(const Points& outline, std::size_t k, double window);

// [1/m] at the tip, by the same fit.
double tip_curvature(const Points& outline, double window);

// [1/m] the least curvature of the half that is nearer the tip than the back: negative where a neck is concave.
double least_curvature(const Points& outline, double window);

}  // namespace shmoo::hydro
