#pragma once
// Where voxels of two materials touch. The contact of voxels i and j is their Voronoi face, projected on the surface:
// A_ij = a_ij max(0, n.e_ij), e_ij the unit vector from i to j and n the surface's normal there, the mean of the area
// vectors of faces within three spacings. Faces of a staircase or of disordered cells then add up to the area of the
// smooth surface that they stand for (for a plane exactly, by the divergence theorem).
#include <array>

#include "rdme/jump_graph.hpp"

namespace shmoo::rdme {

// Rows of the voxels of materials[0]. `spacing` [m] of the particles, `depth` as in scene::Scene.
template <int D>
Surface make_surface(const Places<D>& places, const base::Box<D>& box, double spacing, double depth,
                     std::array<int, 2> materials);

extern template Surface make_surface(const Places<1>&, const base::Box<1>&, double, double, std::array<int, 2>);
extern template Surface make_surface(const Places<2>&, const base::Box<2>&, double, double, std::array<int, 2>);
extern template Surface make_surface(const Places<3>&, const base::Box<3>&, double, double, std::array<int, 2>);

}  // namespace shmoo::rdme
