#pragma once
// Small matrices of lanes: of eight particles at once.
#include "hydro/lanes.hpp"

namespace shmoo::hydro {

template <int D>
struct LaneMatrix {
  Lane at[D][D];

  Lane trace() const {
    Lane sum = at[0][0];
    for (int a = 1; a < D; ++a) sum += at[a][a];
    return sum;
  }
};

template <int D>
LaneMatrix<D> product(const LaneMatrix<D>& left, const LaneMatrix<D>& right) {
  LaneMatrix<D> result;
  for (int a = 0; a < D; ++a) {
    for (int b = 0; b < D; ++b) {
      result.at[a][b] = left.at[a][0] * right.at[0][b];
      for (int c = 1; c < D; ++c) result.at[a][b] += left.at[a][c] * right.at[c][b];
    }
  }
  return result;
}

// M^-1 of a symmetric M of which a <= b is given, or 1 where its determinant is not above `least`.
template <int D>
LaneMatrix<D> symmetric_inverse(const Lane (&m)[D][D], double least) {
  LaneMatrix<D> cofactor;
  auto& c = cofactor.at;
  if constexpr (D == 2) {
    c[0][0] = m[1][1];
    c[0][1] = -m[0][1];
    c[1][1] = m[0][0];
  } else {
    c[0][0] = m[1][1] * m[2][2] - m[1][2] * m[1][2];
    c[0][1] = m[0][2] * m[1][2] - m[0][1] * m[2][2];
    c[0][2] = m[0][1] * m[1][2] - m[0][2] * m[1][1];
    c[1][1] = m[0][0] * m[2][2] - m[0][2] * m[0][2];
    c[1][2] = m[0][1] * m[0][2] - m[0][0] * m[1][2];
    c[2][2] = m[0][0] * m[1][1] - m[0][1] * m[0][1];
  }
  Lane determinant = m[0][0] * c[0][0];
  for (int a = 1; a < D; ++a) determinant += m[0][a] * c[0][a];
  for (int a = 0; a < D; ++a) {
    for (int b = a; b < D; ++b) {
      const Lane unit = same(a == b ? 1.0 : 0.0);
      c[a][b] = determinant > least ? c[a][b] / determinant : unit;
      c[b][a] = c[a][b];
    }
  }
  return cofactor;
}

}  // namespace shmoo::hydro
