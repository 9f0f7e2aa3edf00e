#include "rdme/samplers/groups.hpp"

#include <algorithm>

namespace shmoo::rdme {

void Groups::clear(std::size_t voxels) {
  entries_.assign(voxels, {});
  mass_.fill(0.0);
  for (auto& members : members_) members.clear();
  lowest_ = none;
  highest_ = 0;
  sum_ = 0;
}

void Groups::move(std::uint32_t voxel, std::uint32_t group) {
  Entry& entry = entries_[voxel];
  if (entry.group != none) {
    std::vector<std::uint32_t>& members = members_[entry.group];
    members[entry.place] = members.back();
    entries_[members.back()].place = entry.place;
    members.pop_back();
    mass_[entry.group] = static_cast<double>(members.size()) * width(entry.group);
  }
  entry.group = group;
  if (group != none) {
    entry.place = static_cast<std::uint32_t>(members_[group].size());
    members_[group].push_back(voxel);
    mass_[group] = static_cast<double>(members_[group].size()) * width(group);
    lowest_ = std::min(lowest_, group);
    highest_ = std::max(highest_, group);
  }
  sum_ = 0;
  for (std::uint32_t g = highest_ + 1; g-- > lowest_;) sum_ += mass_[g];
}

}  // namespace shmoo::rdme
