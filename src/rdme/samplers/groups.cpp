#include "rdme/samplers/groups.hpp"

#include <algorithm>

#ifdef __AVX512F__
#include <immintrin.h>
#endif

namespace shmoo::rdme {

void Groups::clear(std::size_t voxels) {
  entries_.assign(voxels, {});
  members_.clear();
  first_.fill(0);
  size_.fill(0);
  room_.fill(0);
  lowest_ = highest_ = none;
  sum_ = 0;
  occupied_ = 0;
}

void Groups::make_room(std::uint32_t group) {
  const std::uint32_t room = std::max(8U, 2 * room_[group]);
  if (members_.size() + room > 8 * entries_.size() + 4096) compact();
  const auto from = static_cast<std::uint32_t>(members_.size());
  members_.resize(from + room);
  std::copy_n(members_.begin() + first_[group], size_[group], members_.begin() + from);
  first_[group] = from;
  room_[group] = room;
}

// Leaves out what groups have moved away from.
void Groups::compact() {
  std::vector<std::uint32_t> packed;
  packed.reserve(4 * entries_.size());
  for (std::size_t g = 0; g < first_.size(); ++g) {
    const auto members = members_.begin() + first_[g];
    first_[g] = static_cast<std::uint32_t>(packed.size());
    packed.insert(packed.end(), members, members + size_[g]);
    room_[g] = size_[g];
  }
  members_ = std::move(packed);
}

void Groups::remove(std::uint32_t voxel) {
  const Entry& entry = entries_[voxel];
  std::uint32_t* const members = members_.data() + first_[entry.group];
  const std::uint32_t last = members[--size_[entry.group]];
  members[entry.place] = last;
  entries_[last].place = entry.place;
  --occupied_;
}

void Groups::add(std::uint32_t voxel, std::uint32_t group) {
  if (size_[group] == room_[group]) make_room(group);
  Entry& entry = entries_[voxel];
  entry.place = size_[group]++;
  members_[first_[group] + entry.place] = voxel;
  ++occupied_;
  lowest_ = std::min(lowest_, group);
  highest_ = highest_ == none ? group : std::max(highest_, group);
}

void Groups::move(std::uint32_t voxel, std::uint32_t group) {
  ++version_;
  Entry& entry = entries_[voxel];
  if (entry.group != none) remove(voxel);
  entry.group = group;
  if (group != none) add(voxel, group);
  // The lowest and highest that hold a voxel: what lies outside must never be picked by round-off.
  while (lowest_ < highest_ && size_[lowest_] == 0) ++lowest_;
  while (highest_ > lowest_ && size_[highest_] == 0) --highest_;
  sum_ = 0;
  for (std::uint32_t g = highest_; g + 1 > lowest_; --g) {
    before_[highest_ - g] = sum_;
    sum_ += static_cast<double>(size_[g]) * width(g);
    if (g == 0) break;
  }
}

#ifdef __AVX512F__
void Groups::pick(const double* uniform, std::size_t number, std::uint32_t* voxel, double* rest) const {
  const __m512d sum = _mm512_set1_pd(sum_);
  const std::uint32_t last = highest_ - lowest_;
  const auto first = reinterpret_cast<const int*>(first_.data()), size = reinterpret_cast<const int*>(size_.data());
  const auto members = reinterpret_cast<const int*>(members_.data());
  for (std::size_t at = 0; at < number; at += 8) {
    const auto lanes = static_cast<__mmask8>(number - at < 8 ? (1U << (number - at)) - 1U : 0xFFU);
    const __m512d x = _mm512_mul_pd(_mm512_maskz_loadu_pd(lanes, uniform + at), sum);
    __m512i passed = _mm512_setzero_si512();  // groups passed over
    for (std::uint32_t g = 1; g <= last; ++g) {
      const __mmask8 beyond = _mm512_cmp_pd_mask(x, _mm512_set1_pd(before_[g]), _CMP_GE_OQ);
      passed = _mm512_mask_add_epi64(passed, beyond, passed, _mm512_set1_epi64(1));
    }
    const __m512i group = _mm512_sub_epi64(_mm512_set1_epi64(highest_), passed);
    const __m512d width = _mm512_castsi512_pd(_mm512_slli_epi64(_mm512_add_epi64(group, _mm512_set1_epi64(1)), 52));
    const __m512d inverse =
        _mm512_castsi512_pd(_mm512_slli_epi64(_mm512_sub_epi64(_mm512_set1_epi64(2045), group), 52));
    const __m512d before = _mm512_i64gather_pd(passed, before_.data(), 8);
    const __m512d place = _mm512_mul_pd(_mm512_sub_pd(x, before), inverse);
    const __m256i most = _mm256_sub_epi32(_mm512_i64gather_epi32(group, size, 4), _mm256_set1_epi32(1));
    const __m256i member = _mm256_min_epu32(_mm512_cvttpd_epu32(place), most);
    const __m256i where = _mm256_add_epi32(_mm512_i64gather_epi32(group, first, 4), member);
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(voxel + at), _mm256_i32gather_epi32(members, where, 4));
    _mm512_storeu_pd(rest + at, _mm512_mul_pd(_mm512_sub_pd(place, _mm512_cvtepu32_pd(member)), width));
  }
}
#else
void Groups::pick(const double* uniform, std::size_t number, std::uint32_t* voxel, double* rest) const {
  for (std::size_t at = 0; at < number; ++at) {
    const Pick one = pick(uniform[at]);
    voxel[at] = one.member;
    rest[at] = one.rest;
  }
}
#endif

}  // namespace shmoo::rdme
