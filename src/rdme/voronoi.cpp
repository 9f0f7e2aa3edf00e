#include "rdme/voronoi.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <voro++/voro++.hh>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

struct Face {
  std::uint32_t smaller, larger;  // particles
  double weight;
};

// In units of the spacing: the tolerances of Voro++ are absolute.
template <int D>
class Tessellation {
 public:
  Tessellation(const base::Box<D>& box, double spacing) : box_(box), spacing_(spacing) {
    std::array<double, 3> lower, upper;
    std::array<int, 3> blocks{1, 1, 1};
    std::array<bool, 3> periodic{};
    constexpr double points_per_block = 5.0;
    for (std::size_t a = 0; a < 3; ++a) {  // an axis that is missing is one spacing thick
      const bool real = a < std::size_t(D);
      lower[a] = real ? box.lower[int(a)] / spacing : -0.5;
      upper[a] = real ? box.upper[int(a)] / spacing : 0.5;
      periodic[a] = real && box.periodic[a];
      if (real) blocks[a] = std::max(1, int((upper[a] - lower[a]) / std::pow(points_per_block, 1.0 / D)));
    }
    container_ =
        std::make_unique<voro::container>(lower[0], upper[0], lower[1], upper[1], lower[2], upper[2], blocks[0],
                                          blocks[1], blocks[2], periodic[0], periodic[1], periodic[2], 8);
  }

  void put(std::size_t index, const base::Vec<D>& place) {
    std::array<double, 3> x{};
    for (int a = 0; a < D; ++a) x[std::size_t(a)] = place[a] / spacing_;
    container_->put(int(index), x[0], x[1], x[2]);
  }

  // Volumes and faces of the particles; every face is found from both of its cells and counts half each time. What
  // round-off lets one cell see and the other not is too small to matter.
  void cells(std::span<const base::Vec<D>> position, std::vector<double>& volume, std::vector<Face>& faces) const {
    constexpr double least = 1e-9;  // area of a face that counts
    const double unit_volume = std::pow(spacing_, D), unit_area = unit_volume / spacing_;
    double filled = 0.0;
    std::vector<int> neighbour;
    std::vector<double> area;
    voro::voronoicell_neighbor cell;
    voro::c_loop_all loop(*container_);
    if (!loop.start()) return;
    do {
      const auto i = std::size_t(loop.pid());
      if (!container_->compute_cell(cell, loop)) continue;
      filled += cell.volume() * unit_volume;
      if (i >= position.size()) continue;
      volume[i] = cell.volume() * unit_volume;
      cell.neighbors(neighbour);
      cell.face_areas(area);
      for (std::size_t f = 0; f < neighbour.size(); ++f) {
        const auto j = std::size_t(neighbour[f]);
        if (neighbour[f] < 0 || j == i || j >= position.size() || area[f] < least) continue;
        const double r = box_.nearest(position[i] - position[j]).norm();
        faces.push_back({std::uint32_t(std::min(i, j)), std::uint32_t(std::max(i, j)), 0.5 * area[f] * unit_area / r});
      }
    } while (loop.inc());
    const bool all = std::find(volume.begin(), volume.end(), 0.0) == volume.end();
    if (all && std::abs(filled / box_.volume() - 1.0) < 1e-6) return;
    throw base::RunError(fmt::format(
        "the Voronoi cells of {} particles fill {:.6g} of the domain: particles coincide or lie outside; use a smaller "
        "domain.jitter, or look at how the flow behaves",
        position.size(), filled / box_.volume()));
  }

 private:
  base::Box<D> box_;
  double spacing_;
  std::unique_ptr<voro::container> container_;
};

// One face for each pair, the sum of its halves.
void merge(std::vector<Face>& faces) {
  const auto key = [](const Face& face) { return std::pair(face.smaller, face.larger); };
  std::stable_sort(faces.begin(), faces.end(), [&](const Face& a, const Face& b) { return key(a) < key(b); });
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (kept > 0 && key(faces[kept - 1]) == key(faces[f]))
      faces[kept - 1].weight += faces[f].weight;
    else
      faces[kept++] = faces[f];
  }
  faces.resize(kept);
}

}  // namespace

template <int D>
VoronoiCells voronoi_cells(std::span<const base::Vec<D>> position, std::span<const base::Vec<D>> vacant,
                           const base::Box<D>& box, double spacing) {
  Tessellation<D> tessellation(box, spacing);
  for (std::size_t i = 0; i < position.size(); ++i) tessellation.put(i, position[i]);
  for (std::size_t i = 0; i < vacant.size(); ++i) tessellation.put(position.size() + i, vacant[i]);
  VoronoiCells rows;
  rows.volume.assign(position.size(), 0.0);
  std::vector<Face> faces;
  tessellation.cells(position, rows.volume, faces);
  merge(faces);
  rows.first.assign(position.size() + 1, 0);
  for (const Face& face : faces) {
    ++rows.first[face.smaller + 1];
    ++rows.first[face.larger + 1];
  }
  for (std::size_t i = 0; i < position.size(); ++i) rows.first[i + 1] += rows.first[i];
  rows.target.resize(rows.first.back());
  rows.weight.resize(rows.first.back());
  auto next = rows.first;
  const auto put = [&](std::uint32_t from, std::uint32_t to, double weight) {
    const std::uint64_t place = next[from]++;
    rows.target[place] = to;
    rows.weight[place] = weight;
  };
  // Sorted by (smaller, larger): first the smaller partners of every particle, then the larger ones, both ascending.
  for (const Face& face : faces) put(face.larger, face.smaller, face.weight);
  for (const Face& face : faces) put(face.smaller, face.larger, face.weight);
  return rows;
}

template VoronoiCells voronoi_cells(std::span<const base::Vec<1>>, std::span<const base::Vec<1>>, const base::Box<1>&,
                                    double);
template VoronoiCells voronoi_cells(std::span<const base::Vec<2>>, std::span<const base::Vec<2>>, const base::Box<2>&,
                                    double);
template VoronoiCells voronoi_cells(std::span<const base::Vec<3>>, std::span<const base::Vec<3>>, const base::Box<3>&,
                                    double);

}  // namespace shmoo::rdme
