#pragma once
// Voxels sorted by the power of two above their total rate, and the choice of one of them by composition and rejection
// (Slepoy, Thompson, Plimpton 2008, J. Chem. Phys. 128, 205101).
//
// A group of n voxels with totals in [2^(e-1), 2^e) has the mass n 2^e, so the sum of all masses is made of whole
// numbers and carries no round-off from event to event. Events are drawn at that sum; a voxel of total a is then
// accepted with probability a/2^e, at least one half. What is rejected is a moment at which nothing happens, which
// leaves the law exact (thinning: Lewis and Shedler 1979).
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace shmoo::rdme {

class Groups {
 public:
  struct Pick {
    std::uint32_t voxel;
    double rest;  // uniform in [0, 2^e): an event of the voxel where below its total
  };

  void clear(std::size_t voxels);

  // The voxel's total rate is now `total` [1/s]: finite, >= 0.
  void set(std::uint32_t voxel, double total) {
    Entry& entry = entries_[voxel];
    entry.total = total;
    if (total >= entry.above || total < entry.low) move(voxel, total > 0 ? exponent(total) : none);
  }

  double total(std::uint32_t voxel) const { return entries_[voxel].total; }
  double sum() const { return sum_; }                 // [1/s] of all masses
  std::size_t occupied() const { return occupied_; }  // voxels of total > 0
  std::uint64_t version() const { return version_; }  // changes where a voxel changes its group

  // By a uniform number in (0, 1). The sum must not be 0.
  Pick pick(double uniform) const {
    const double x = uniform * sum_;
    const std::uint32_t last = highest_ - lowest_;
    std::uint32_t k = 0;  // groups passed over, counted without branches
    for (std::uint32_t g = 1; g <= last; ++g) k += x >= before_[g] ? 1U : 0U;
    const std::uint32_t group = highest_ - k;
    const std::vector<std::uint32_t>& members = members_[group];
    const double place = (x - before_[k]) * inverse_width(group);
    std::size_t m = static_cast<std::size_t>(place);
    if (m >= members.size()) m = members.size() - 1;
    return {members[m], (place - static_cast<double>(m)) * width(group)};
  }

  void prefetch(std::uint32_t voxel) const { __builtin_prefetch(&entries_[voxel], 1); }

 private:
  static constexpr std::uint32_t none = 2047;  // not a finite number's exponent
  struct Entry {
    double total = 0;
    double low = 0, above = 0x1p-1074;  // where the group holds: low <= total < above; outside all groups: total == 0
    std::uint32_t group = none, place = 0;
  };
  static constexpr double least_share = 0.35;  // of 2^e

  static std::uint32_t exponent(double x) { return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(x) >> 52); }
  // 2^e above all totals of a group, and its inverse. Rates beyond 2^1000 are refused elsewhere.
  static double width(std::uint32_t group) { return std::bit_cast<double>(std::uint64_t{group + 1} << 52); }
  static double inverse_width(std::uint32_t group) { return std::bit_cast<double>(std::uint64_t{2045 - group} << 52); }

  void move(std::uint32_t voxel, std::uint32_t group);

  std::vector<Entry> entries_;
  std::array<double, 2048> before_{};  // masses of all groups above the k-th, counted from the highest
  std::array<std::vector<std::uint32_t>, 2048> members_;
  std::uint32_t lowest_ = 0, highest_ = 0;  // groups that may have members
  double sum_ = 0;
  std::size_t occupied_ = 0;
  std::uint64_t version_ = 0;
};

}  // namespace shmoo::rdme
