#include "hydro/shell/stencil.hpp"

#include <algorithm>
#include <cmath>

#include "sph/kernel.hpp"

namespace shmoo::hydro {
namespace {

constexpr double reach = 2.6;  // steps on the lattice

Neighbour neighbour(const Shell& shell, int column, int layer) {
  const bool before = column < 0, beyond = column >= shell.columns;
  if (before) column = -1 - column;
  if (beyond) column = 2 * shell.columns - 1 - column;
  return {shell.at(column, layer), before || beyond ? -1.0 : 1.0};
}

Row row(const Shell& shell, int column, int layer) {
  const sph::WendlandC2<2> kernel(reach);
  const int steps = int(reach);
  const Vec2 own = shell.X[shell.at(column, layer)];
  Row found{neighbour(shell, column, layer)};
  Mat2 moment = Mat2::Zero();
  double total = 0.0;
  for (int k = -steps; k <= steps; ++k) {
    for (int l = std::max(-steps, -layer); l <= std::min(steps, shell.layers - 1 - layer); ++l) {
      const double distance = std::hypot(k, l);
      if (distance == 0.0 || distance >= reach) continue;
      Neighbour one = neighbour(shell, column + k, layer + l);
      const Vec2 apart = one.place(shell.X) - own;
      one.gradient = kernel.F(distance) * apart;
      one.weight = kernel.W(distance);
      moment += one.gradient * apart.transpose();
      total += one.weight;
      found.push_back(one);
    }
  }
  const Mat2 correction = moment.inverse();
  for (auto& one : found) {
    one.gradient = correction * one.gradient;
    one.weight /= total;
    if (&one != &found.front()) found.front().gradient -= one.gradient;
  }
  return found;
}

}  // namespace

std::vector<Row> make_stencil(const Shell& shell) {
  std::vector<Row> rows;
  for (int k = 0; k < shell.columns; ++k) {
    for (int l = 0; l < shell.layers; ++l) rows.push_back(row(shell, k, l));
  }
  return rows;
}

}  // namespace shmoo::hydro
