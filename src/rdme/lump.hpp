#pragma once
// A coarse likeness of a geometry: groups of voxels of one material become one voxel each. Volumes, areas, carried
// volumes, exits and entries add up. Where groups touch, the conductances of their pairs add up too, times the distance
// of the voxels over that of the groups' centres, so that gradients over many groups carry the flux that they should.
#include <array>
#include <cstdint>
#include <vector>

#include "rdme/voxels.hpp"

namespace shmoo::rdme {

struct Lumps {
  Voxels voxels;
  std::vector<std::uint32_t> of;  // by voxel of what was lumped
};

// Neighbours of one material are lumped by cubes of space into at most `most` voxels, unless there are more materials;
// so few voxels stay as they are. `period` [m] of each axis; 0: not periodic.
Lumps lump(const Voxels& voxels, std::size_t most, const std::array<double, 3>& period);

}  // namespace shmoo::rdme
