#include "rdme/samplers/groups.hpp"

#include <algorithm>

namespace shmoo::rdme {

void Groups::clear(std::size_t voxels) {
  entries_.assign(voxels, {});
  for (auto& members : members_) members.clear();
  lowest_ = highest_ = none;
  sum_ = 0;
  occupied_ = 0;
}

void Groups::move(std::uint32_t voxel, std::uint32_t group) {
  ++version_;
  Entry& entry = entries_[voxel];
  if (entry.group != none) {
    std::vector<std::uint32_t>& members = members_[entry.group];
    members[entry.place] = members.back();
    entries_[members.back()].place = entry.place;
    members.pop_back();
    --occupied_;
  }
  entry.group = group;
  entry.low = 0;
  entry.above = 0x1p-1074;
  if (group != none) {
    entry.low = least_share * width(group);
    entry.above = width(group);
    ++occupied_;
    entry.place = static_cast<std::uint32_t>(members_[group].size());
    members_[group].push_back(voxel);
    lowest_ = std::min(lowest_, group);
    highest_ = highest_ == none ? group : std::max(highest_, group);
  }
  // The lowest and highest that hold a voxel: what lies outside must never be picked by round-off.
  while (lowest_ < highest_ && members_[lowest_].empty()) ++lowest_;
  while (highest_ > lowest_ && members_[highest_].empty()) --highest_;
  sum_ = 0;
  for (std::uint32_t g = highest_; g + 1 > lowest_; --g) {
    before_[highest_ - g] = sum_;
    sum_ += static_cast<double>(members_[g].size()) * width(g);
    if (g == 0) break;
  }
}

}  // namespace shmoo::rdme
