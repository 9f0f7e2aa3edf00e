#pragma once
// Faces between the Voronoi cells of particles: the pair weights A_ij/r_ij are positive and symmetric, sum_j
// (A_ij/r_ij) x_ij = 0 for every cell away from sides whatever the arrangement, and with the face at a side also next
// to it. Diffusion through them is exact for linear profiles and of second order on disordered particles (Eymard,
// Gallouet, Herbin, Finite volume methods, 2000), which kernel weights are not. Cells are found by Voro++ (Rycroft,
// Chaos 19, 041111, 2009).
#include <cstdint>
#include <span>
#include <vector>

#include "base/box.hpp"

namespace shmoo::rdme {

struct VoronoiCells {
  std::vector<std::uint64_t> first;   // [particles + 1]
  std::vector<std::uint32_t> target;  // [faces] ascending within a row; a face stands in both rows
  std::vector<double> weight;         // [faces] A_ij/r_ij [m^(D-2)], the same bits in both rows
  std::vector<double> volume;         // [particles] [m^D]
};

// `vacant` [m] are further points that have cells but are no particles: they bound the cells beside a void. `spacing`
// [m] is the typical distance of points. All points lie in the box, and every periodic extent is at least four
// spacings. Throws base::RunError where points coincide or lie outside.
template <int D>
VoronoiCells voronoi_cells(std::span<const base::Vec<D>> position, std::span<const base::Vec<D>> vacant,
                           const base::Box<D>& box, double spacing);

extern template VoronoiCells voronoi_cells(std::span<const base::Vec<1>>, std::span<const base::Vec<1>>,
                                           const base::Box<1>&, double);
extern template VoronoiCells voronoi_cells(std::span<const base::Vec<2>>, std::span<const base::Vec<2>>,
                                           const base::Box<2>&, double);
extern template VoronoiCells voronoi_cells(std::span<const base::Vec<3>>, std::span<const base::Vec<3>>,
                                           const base::Box<3>&, double);

}  // namespace shmoo::rdme
