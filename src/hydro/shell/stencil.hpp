#pragma once
// The neighbourhood of a shell's particles: those within 2.6 steps on the lattice of columns and layers, mirror images
// beyond the axis included. Weights are Wendland's C2 of the distance on that lattice, which is a kernel that stretches
// with the particles' spacing in each direction (Owen, Villumsen, Shapiro & Martel 1998, Astrophys. J. Suppl. 116,
// 155), and gradients are corrected as in solid/reference_rows.hpp.
#include "hydro/shell/shell.hpp"

namespace shmoo::hydro {

struct Neighbour {
  std::size_t particle = 0;
  double mirror = 1;             // -1: its image beyond the axis
  Vec2 gradient = Vec2::Zero();  // [1/m] grad f_i = sum_j f_j g_ij, i included
  double weight = 0;             // kernel weights, without i; add up to 1

  Vec2 place(const std::vector<Vec2>& x) const { return {x[particle][0], mirror * x[particle][1]}; }
};

// The first of a row is the particle itself.
using Row = std::vector<Neighbour>;

std::vector<Row> make_stencil(const Shell& shell);

inline Mat2 deformation_gradient(const Row& row, const std::vector<Vec2>& x) {
  Mat2 F = Mat2::Zero();
  for (const auto& one : row) F += one.place(x) * one.gradient.transpose();
  return F;
}

}  // namespace shmoo::hydro
