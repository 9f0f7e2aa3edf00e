#pragma once
// Pairs are worked on eight at a time, and sums over neighbours are kept in eight lanes, in this order on every
// machine: the compiler may use vector registers of any width, or none, and the bits stay the same whichever effects
// share the loop.
#include <cstddef>
#include <cstdint>

namespace shmoo::hydro {

// Whether so many particles are enough work in a pair sweep to start threads for. The bits do not depend on it.
inline bool worth_threads(std::size_t particles) { return particles >= 3000; }

inline constexpr int lanes = 8;  // neighbour rows are padded to a multiple of this

// Element-wise arithmetic, comparison and choice (`mask ? a : b`), as GCC and Clang define them for vector types.
using Lane = double __attribute__((vector_size(lanes * sizeof(double))));

inline double total(const Lane& sum) {
  return ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7]));
}

// values[stride j + offset] for the eight partners j.
inline void gather(Lane& result, const double* values, const std::int32_t* partner, int stride = 1, int offset = 0) {
  const auto at = [&](int l) { return values[std::int64_t(stride) * partner[l] + offset]; };
  result = Lane{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}

// Separations along one axis of the box, the shortest image where the axis is periodic; antisymmetric to the bit.
struct Axis {
  double length = 0;  // [m]
  double half = 0;    // [m]; infinite where the axis is not periodic

  double nearest(double d) const {
    d = d > half ? d - length : d;
    return d < -half ? d + length : d;
  }
  void to_nearest(Lane& d) const {
    d = d > half ? d - length : d;
    d = d < -half ? d + length : d;
  }
};

}  // namespace shmoo::hydro
