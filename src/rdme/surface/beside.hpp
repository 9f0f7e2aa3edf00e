#pragma once
// Which voxels of surfaces' first materials touch a voxel: their propensities change with its numbers.
#include <cstdint>
#include <span>
#include <vector>

#include "rdme/voxels.hpp"

namespace shmoo::rdme {

class Beside {
 public:
  Beside() = default;
  Beside(const std::vector<Surface>& surfaces, std::size_t voxels) {
    if (surfaces.empty()) return;
    std::vector<std::vector<std::uint32_t>> rows(voxels);
    for (const Surface& surface : surfaces)
      for (std::uint32_t i = 0; i < voxels; ++i)
        for (std::uint64_t p = surface.first[i]; p < surface.first[i + 1]; ++p) rows[surface.target[p]].push_back(i);
    for (const auto& row : rows) {
      first_.push_back(voxel_.size());
      voxel_.insert(voxel_.end(), row.begin(), row.end());
    }
    first_.push_back(voxel_.size());
  }

  bool any() const { return !first_.empty(); }
  std::span<const std::uint32_t> of(std::size_t voxel) const {
    if (first_.empty()) return {};
    return {voxel_.data() + first_[voxel], voxel_.data() + first_[voxel + 1]};
  }

 private:
  std::vector<std::uint64_t> first_;  // [voxels + 1]; empty where there are no surfaces
  std::vector<std::uint32_t> voxel_;
};

}  // namespace shmoo::rdme
