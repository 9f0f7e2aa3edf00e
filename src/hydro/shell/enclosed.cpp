#include "hydro/shell/enclosed.hpp"

#include <numbers>

namespace shmoo::hydro {
namespace {

using std::numbers::pi;

double length(const Edge& e) { return e[0] - e[2]; }
double middle(const Edge& e) { return 0.5 * (e[1] + e[3]); }

}  // namespace

Edge edge_at(const std::vector<Vec2>& outline, std::size_t k) {
  Edge e;
  e << outline[k], outline[k + 1];
  return e;
}

double edge_volume(bool axial, const Edge& e) { return (axial ? pi * middle(e) * middle(e) : middle(e)) * length(e); }

Edge edge_gradient(bool axial, const Edge& e) {
  const double m = middle(e), face = axial ? pi * m * m : m, side = (axial ? pi * m : 0.5) * length(e);
  return {face, side, -face, side};
}

Eigen::Matrix4d edge_hessian(bool axial, const Edge& e) {
  const double by_y = axial ? pi * middle(e) : 0.5, twice = axial ? 0.5 * pi * length(e) : 0.0;
  Eigen::Matrix4d h = Eigen::Matrix4d::Zero();
  for (const int y : {1, 3}) {
    h(0, y) = h(y, 0) = by_y;
    h(2, y) = h(y, 2) = -by_y;
    h(y, 1) = h(y, 3) = twice;
  }
  return h;
}

std::vector<Row> outline_rows(const Shell& shell, const std::vector<Row>& rows, int layer,
                              const std::vector<Vec2>& offset) {
  std::vector<Row> outline;
  for (int k = 0; k < shell.columns; ++k) {
    outline.push_back(rows[shell.at(k, layer)]);
    for (auto& one : outline.back()) one.weight = one.gradient.dot(offset[std::size_t(k)]);
    outline.back().front().weight += 1.0;
  }
  return outline;
}

std::vector<Vec2> points(const std::vector<Row>& outline, const std::vector<Vec2>& x) {
  std::vector<Vec2> all;
  for (const auto& row : outline) {
    all.emplace_back(Vec2::Zero());
    for (const auto& one : row) all.back() += one.weight * one.place(x);
  }
  return all;
}

}  // namespace shmoo::hydro
