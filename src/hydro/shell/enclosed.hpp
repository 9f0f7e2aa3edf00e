#pragma once
// The volume between the x axis and a curve told by points, edge by edge: turned about the axis, or per unit depth. An
// edge counts as the cylinder of its middle, so that an outline whose first point is half a column from the axis is
// pressed on by just the disc that belongs to it: cones would press 13/12 of that.
#include <Eigen/Core>

#include "hydro/shell/stencil.hpp"

namespace shmoo::hydro {

using Edge = Eigen::Vector4d;  // [m] x, y of its first and its second point

Edge edge_at(const std::vector<Vec2>& outline, std::size_t k);
double edge_volume(bool axial, const Edge& edge);  // [m^3], plane: [m^2]
Edge edge_gradient(bool axial, const Edge& edge);  // by its coordinates
Eigen::Matrix4d edge_hessian(bool axial, const Edge& edge);

// Points s_k = x_k + F_k offset_k beside the particles of a layer, by column, as sums over the particle's neighbours:
// the weights of the rows returned.
std::vector<Row> outline_rows(const Shell& shell, const std::vector<Row>& rows, int layer,
                              const std::vector<Vec2>& offset);
std::vector<Vec2> points(const std::vector<Row>& outline, const std::vector<Vec2>& x);

}  // namespace shmoo::hydro
