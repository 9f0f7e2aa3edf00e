#pragma once
// Eight particles side by side: arithmetic on them in one go, in vector registers of any width or none. On one
// instruction set the bits are the same whichever effects share a loop and however many threads run.
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#if defined(__AVX512F__) || defined(__FMA__)
#include <immintrin.h>
#endif

#pragma GCC diagnostic ignored "-Wpsabi"  // no vector crosses the border of a library

namespace shmoo::base {

inline constexpr int lanes = 8;

// Element-wise arithmetic, comparison and choice (`mask ? a : b`), as GCC and Clang define them for vector types.
using Lane = double __attribute__((vector_size(lanes * sizeof(double))));

using LaneArray = std::vector<double, Eigen::aligned_allocator<double>>;

inline Lane load(const double* values) {
  Lane lane;
  __builtin_memcpy(&lane, values, sizeof(lane));
  return lane;
}

inline void store(const Lane& lane, double* values) { __builtin_memcpy(values, &lane, sizeof(lane)); }

inline Lane same(double value) { return Lane{} + value; }

// a b + c, rounded once where the processor can.
inline Lane fma(const Lane& a, const Lane& b, const Lane& c) {
#if defined(__AVX512F__)
  return Lane(_mm512_fmadd_pd(__m512d(a), __m512d(b), __m512d(c)));
#elif defined(__FMA__)
  Lane result;
  for (int l = 0; l < lanes; ++l) result[l] = __builtin_fma(a[l], b[l], c[l]);
  return result;
#else
  return a * b + c;
#endif
}

// c - a b, likewise.
inline Lane less_product(const Lane& c, const Lane& a, const Lane& b) {
#if defined(__AVX512F__)
  return Lane(_mm512_fnmadd_pd(__m512d(a), __m512d(b), __m512d(c)));
#else
  return fma(-a, b, c);
#endif
}

inline Lane larger(const Lane& a, const Lane& b) { return a > b ? a : b; }

inline bool any_below(const Lane& a, double limit) {
#if defined(__AVX512F__)
  return _mm512_cmp_pd_mask(__m512d(a), _mm512_set1_pd(limit), _CMP_LT_OQ) != 0;
#else
  bool any = false;
  for (int l = 0; l < lanes; ++l) any |= a[l] < limit;
  return any;
#endif
}

// 1/sqrt(a), a > 0, to the last bit or two: an estimate good to 2^-14, and four terms of the series of (1 - e)^(-1/2).
inline Lane inverse_root(const Lane& a) {
#if defined(__AVX512F__)
  const Lane y = Lane(_mm512_maskz_rsqrt14_pd(0xFF, __m512d(a)));
  const Lane e = less_product(same(1.0), a * y, y);
  return fma(y * e, fma(e, fma(e, same(0.3125), same(0.375)), same(0.5)), y);
#else
  Lane result;
  for (int l = 0; l < lanes; ++l) result[l] = 1.0 / std::sqrt(a[l]);
  return result;
#endif
}

}  // namespace shmoo::base
