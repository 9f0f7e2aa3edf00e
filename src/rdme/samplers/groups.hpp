#pragma once
// Voxels sorted by the power of two above their total rate, and the choice of one of them by composition and rejection
// (Slepoy, Thompson, Plimpton 2008, J. Chem. Phys. 128, 205101).
//
// A group of n voxels with totals in [2^(e-1), 2^e) has the mass n 2^e, so the sum of all masses is made of whole
// numbers and carries no round-off from event to event. Events are drawn at that sum; a voxel of total a is then
// accepted with probability a/2^e, at least one half. What is rejected is a moment at which nothing happens, which
// leaves the law exact (thinning: Lewis and Shedler 1979).
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace shmoo::rdme {

class Groups {
 public:
  void clear(std::size_t voxels);

  // The voxel's total rate is now `total` [1/s]: finite, >= 0.
  void set(std::uint32_t voxel, double total) {
    Entry& entry = entries_[voxel];
    entry.total = total;
    const double above = width(entry.group);
    if (total < above && total >= least_share * above) return;
    if (total > 0 || entry.group != none) move(voxel, total > 0 ? exponent(total) : none);
  }

  double total(std::uint32_t voxel) const { return entries_[voxel].total; }
  double sum() const { return sum_; }                 // [1/s] of all masses
  std::size_t occupied() const { return occupied_; }  // voxels of total > 0
  std::uint64_t version() const { return version_; }  // changes where a voxel changes its group

  struct Pick {
    std::uint32_t member;
    double rest;  // uniform in [0, 2^e): an event of the member where below its total
  };

  // By a uniform number in (0, 1). The sum must not be 0.
  Pick pick(double uniform) const {
    const double x = uniform * sum_;
    const std::uint32_t last = highest_ - lowest_;
    std::uint32_t passed = 0;  // groups passed over, counted without branches
    for (std::uint32_t g = 1; g <= last; ++g) passed += x >= before_[g] ? 1U : 0U;
    const std::uint32_t group = highest_ - passed;
    const double place = (x - before_[passed]) * inverse_width(group);
    const std::uint32_t member = std::min(static_cast<std::uint32_t>(place), size_[group] - 1);
    return {members_[first_[group] + member], (place - static_cast<double>(member)) * width(group)};
  }

  // By uniform numbers in (0, 1), one pick for each, up to 32 of them. The sum must not be 0. Each pick is a voxel and
  // a number that is uniform in [0, 2^e): an event of the voxel where below its total. May write up to seven entries
  // more.
  void pick(const double* uniform, std::size_t number, std::uint32_t* voxel, double* rest) const;

  void prefetch(std::uint32_t voxel) const { __builtin_prefetch(&entries_[voxel], 1); }

 private:
  static constexpr std::uint32_t none = 2047;  // not a finite number's exponent; width(none) holds nothing
  struct Entry {
    double total = 0;
    std::uint32_t group = none, place = 0;  // outside all groups: total == 0
  };
  static constexpr double least_share = 0.35;  // of 2^e

  static std::uint32_t exponent(double x) { return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> 52); }
  // 2^e above all totals of a group, and its inverse. Rates beyond 2^1000 are refused elsewhere.
  static double width(std::uint32_t group) { return std::bit_cast<double>(std::uint64_t{group + 1} << 52); }
  static double inverse_width(std::uint32_t group) { return std::bit_cast<double>(std::uint64_t{2045 - group} << 52); }

  void move(std::uint32_t voxel, std::uint32_t group);

  void add(std::uint32_t voxel, std::uint32_t group);
  void remove(std::uint32_t voxel);
  void make_room(std::uint32_t group);
  void compact();

  std::vector<Entry> entries_;
  std::array<double, 2048> before_{};  // masses of all groups above the k-th, counted from the highest
  // Members of a group: size_ entries of members_ from first_ on, where there is room for room_.
  std::vector<std::uint32_t> members_;
  std::array<std::uint32_t, 2048> first_{}, size_{}, room_{};
  std::uint32_t lowest_ = 0, highest_ = 0;  // groups that may have members
  double sum_ = 0;
  std::size_t occupied_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace shmoo::rdme
