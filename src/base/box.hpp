#pragma once
// The computational domain: an axis-parallel box, each axis periodic or not.
#include <array>
#include <cmath>

#include "base/vec.hpp"

namespace shmoo::base {

template <int D>
struct Box {
  Vec<D> lower = Vec<D>::Zero();    // [m]
  Vec<D> upper = Vec<D>::Ones();    // [m]
  std::array<bool, D> periodic{};

  Vec<D> size() const { return upper - lower; }
  double volume() const { return size().prod(); }  // [m^D]

  // The shortest image of a separation; antisymmetric to the bit: nearest(-d) == -nearest(d).
  Vec<D> nearest(Vec<D> d) const {
    for (int a = 0; a < D; ++a) {
      if (!periodic[a]) continue;
      const double length = upper[a] - lower[a];
      if (d[a] > 0.5 * length) d[a] -= length;
      else if (d[a] < -0.5 * length) d[a] += length;
    }
    return d;
  }

  // The position's image inside the box, along periodic axes only; in [lower, upper).
  Vec<D> wrap(Vec<D> x) const {
    for (int a = 0; a < D; ++a) {
      if (!periodic[a]) continue;
      const double length = upper[a] - lower[a];
      x[a] -= length * std::floor((x[a] - lower[a]) / length);
      if (x[a] >= upper[a]) x[a] = lower[a];
    }
    return x;
  }
};

}  // namespace shmoo::base
