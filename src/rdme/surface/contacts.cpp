#include "rdme/surface/contacts.hpp"

#include <algorithm>

#include "rdme/voronoi.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::rdme {
namespace {

constexpr double smoothing = 3.0;    // spacings over which faces make a normal
constexpr double other_side = -0.5;  // faces that look the other way belong to the other side of a thin wall

template <int D>
struct Face {
  std::uint32_t target;
  double area;             // [m^(D-1)]
  base::Vec<D> direction;  // unit vector out of the voxel
};

template <int D>
std::vector<std::vector<Face<D>>> faces_between(const Places<D>& places, const base::Box<D>& box, double spacing,
                                                std::array<int, 2> materials) {
  const auto cells = voronoi_cells<D>(places.position, places.vacant, box, spacing);
  std::vector<std::vector<Face<D>>> faces(places.position.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (places.material[i] != materials[0]) continue;
    for (std::uint64_t f = cells.first[i]; f < cells.first[i + 1]; ++f) {
      const std::uint32_t j = cells.target[f];
      if (places.material[j] != materials[1]) continue;
      const base::Vec<D> x_ji = box.nearest(places.position[j] - places.position[i]);
      const double r = x_ji.norm();
      faces[i].push_back({j, cells.weight[f] * r, x_ji / r});
    }
  }
  return faces;
}

}  // namespace

template <int D>
Surface make_surface(const Places<D>& places, const base::Box<D>& box, double spacing, double depth,
                     std::array<int, 2> materials) {
  const auto faces = faces_between<D>(places, box, spacing, materials);
  std::vector<std::uint32_t> touching;
  std::vector<base::Vec<D>> position;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].empty()) continue;
    touching.push_back(static_cast<std::uint32_t>(i));
    position.push_back(places.position[i]);
  }
  double reach = smoothing * spacing;
  for (int a = 0; a < D; ++a)
    if (box.periodic[std::size_t(a)]) reach = std::min(reach, 0.499 * box.size()[a]);
  sph::NeighbourRows<D> near;
  near.build(position, box, reach);
  Surface surface{materials, {0}, {}, {}, {}};
  std::size_t next = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    double sum = 0.0;
    for (const Face<D>& face : faces[i]) {
      base::Vec<D> normal = base::Vec<D>::Zero();
      const auto add = [&](std::size_t voxel, double weight) {
        for (const Face<D>& other : faces[voxel])
          if (other.direction.dot(face.direction) > other_side) normal += weight * other.area * other.direction;
      };
      add(i, 1.0);
      for (const std::uint32_t k : near.row(next))
        add(touching[k], 1.0 - box.nearest(position[next] - position[k]).norm() / reach);
      const double cosine = normal.dot(face.direction) / normal.norm();
      if (!(cosine > 0.0)) continue;
      surface.target.push_back(face.target);
      surface.area.push_back(cosine * face.area * depth);
      sum += surface.area.back();
    }
    if (!faces[i].empty()) ++next;
    for (std::uint64_t p = surface.first.back(); p < surface.target.size(); ++p)
      surface.share.push_back(surface.area[p] / sum);
    surface.first.push_back(surface.target.size());
  }
  return surface;
}

template Surface make_surface(const Places<1>&, const base::Box<1>&, double, double, std::array<int, 2>);
template Surface make_surface(const Places<2>&, const base::Box<2>&, double, double, std::array<int, 2>);
template Surface make_surface(const Places<3>&, const base::Box<3>&, double, double, std::array<int, 2>);

}  // namespace shmoo::rdme
