#pragma once
// A list of particles taken eight at a time: what they carry is gathered into lanes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec.hpp"
#include "hydro/lanes.hpp"

namespace shmoo::hydro {

// values[first + stride particle] of eight particles.
inline Lane gather(const double* values, const std::array<std::int32_t, lanes>& particle, int stride, int first) {
#if defined(__AVX512F__)
  __m256i index = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(particle.data()));
  if (stride > 1) index = _mm256_mullo_epi32(index, _mm256_set1_epi32(stride));
  return Lane(_mm512_mask_i32gather_pd(_mm512_setzero_pd(), 0xFF, index, values + first, sizeof(double)));
#else
  Lane lane;
  for (std::size_t l = 0; l < lanes; ++l) lane[l] = values[std::ptrdiff_t(particle[l]) * stride + first];
  return lane;
#endif
}

struct Eight {
  std::array<std::int32_t, lanes> particle;  // where fewer are left, the last ones repeat one of them
  std::uint32_t size;                        // those that are meant
  Lane live;                                 // 1 for them, 0 for the others

  Lane of(const std::vector<double>& values) const { return gather(values.data(), particle, 1, 0); }
  template <int D>
  void of(const std::vector<base::Vec<D>>& values, Lane (&result)[D]) const {
    static_assert(sizeof(base::Vec<D>) == D * sizeof(double));
    for (int a = 0; a < D; ++a) result[a] = gather(values.data()->data(), particle, D, a);
  }
};

// Calls visit(eight, place of its first in the list).
template <class Index, class Visit>
void by_eights(const Index* list, std::size_t size, Visit&& visit) {
  for (std::size_t k = 0; k < size; k += lanes) {
    Eight eight;
    eight.size = std::uint32_t(std::min<std::size_t>(lanes, size - k));
    for (std::uint32_t l = 0; l < lanes; ++l) {
      eight.particle[l] = std::int32_t(list[k + std::min(l, eight.size - 1)]);
      eight.live[l] = l < eight.size ? 1.0 : 0.0;
    }
    visit(eight, k);
  }
}

inline double sum(const Lane& lane) {
  double sum = 0.0;
  for (std::size_t l = 0; l < lanes; ++l) sum += lane[l];
  return sum;
}

template <int D>
base::Vec<D> sum(const Lane (&vector)[D]) {
  base::Vec<D> result;
  for (int a = 0; a < D; ++a) result[a] = sum(vector[a]);
  return result;
}

// x minus the places of eight particles, the shortest images; returns the squares of the distances, none quite 0.
template <int D>
Lane separations(const base::Vec<D>& x, const Eight& eight, const std::vector<base::Vec<D>>& position,
                 const std::array<Axis, D>& axes, Lane (&result)[D]) {
  eight.of<D>(position, result);
  Lane r2 = same(tiny);
  for (int a = 0; a < D; ++a) {
    result[a] = axes[std::size_t(a)].nearest(Lane(x[a] - result[a]));
    r2 = fma(result[a], result[a], r2);
  }
  return r2;
}

}  // namespace shmoo::hydro
