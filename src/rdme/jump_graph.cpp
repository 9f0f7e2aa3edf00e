#include "rdme/jump_graph.hpp"

#include <algorithm>
#include <cmath>

#include "rdme/voronoi.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::rdme {
namespace {

// The voxels and their mirror images in all sides that are not periodic; images of images in edges and corners, too.
template <int D>
struct Mirrored {
  std::vector<base::Vec<D>> position;
  std::vector<std::uint32_t> voxel;   // the particle that stands here or whose image this is
  std::vector<std::uint8_t> crossed;  // bit 2 axis + side: mirrored in that side
};

template <int D>
Mirrored<D> mirror(const Places<D>& places, const base::Box<D>& box, double reach) {
  Mirrored<D> all;
  const std::size_t n = places.position.size();
  all.position.assign(places.position.begin(), places.position.end());
  all.voxel.resize(n);
  all.crossed.assign(n, 0);
  for (std::size_t i = 0; i < n; ++i) all.voxel[i] = static_cast<std::uint32_t>(i);
  for (int a = 0; a < D; ++a) {
    if (box.periodic[a]) continue;
    const std::size_t before = all.position.size();
    for (std::size_t i = 0; i < before; ++i) {
      for (int side = 0; side < 2; ++side) {
        const double plane = side == 0 ? box.lower[a] : box.upper[a];
        if (std::abs(all.position[i][a] - plane) >= reach) continue;
        base::Vec<D> image = all.position[i];
        image[a] = 2.0 * plane - image[a];
        all.position.push_back(image);
        all.voxel.push_back(all.voxel[i]);
        all.crossed.push_back(static_cast<std::uint8_t>(all.crossed[i] | 1u << (2 * a + side)));
      }
    }
  }
  return all;
}

template <int D>
class Builder {
 public:
  Builder(const Places<D>& places, const base::Box<D>& box, const sph::AnyKernel<D>& kernel, double depth,
          const Habitat& habitat)
      : places_(places), box_(box), kernel_(kernel), depth_(depth), habitat_(habitat) {
    const double reach = std::visit([](const auto& k) { return k.reach(); }, kernel);
    mirrored_ = mirror(places, box, reach);
    rows_.build(mirrored_.position, box, reach);
    releases_ = std::find(habitat.source.begin(), habitat.source.end(), true) != habitat.source.end();
    for (int side = 0; side < 2 * D; ++side) {
      if (habitat.side[static_cast<std::size_t>(side)] == SideUse::open) open_ |= static_cast<std::uint8_t>(1u << side);
    }
  }

  HabitatGraph build(PairWeights weights) {
    const std::size_t n = places_.position.size();
    std::vector<Row> rows(n);
    if (weights == PairWeights::faces) {
      const double points = double(n + places_.vacant.size());
      cells_ = voronoi_cells<D>(places_.position, places_.vacant, box_, std::pow(box_.volume() / points, 1.0 / D));
    } else {
      scale_all();
    }
#pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t i = 0; i < n; ++i) rows[i] = weights == PairWeights::faces ? face_row(i) : kernel_row(i);
    HabitatGraph result;
    result.graph.first.assign(n + 1, 0);
    std::size_t pairs = 0;
    for (const Row& row : rows) pairs += row.jumps.size();
    result.graph.target.reserve(pairs);
    result.graph.coupling.reserve(pairs);
    for (std::size_t i = 0; i < n; ++i) {
      add_side_contacts(i, rows[i]);
      append(rows[i], result);
      result.graph.first[i + 1] = result.graph.target.size();
    }
    rescale_flux_areas(result.contacts);
    return result;
  }

 private:
  struct Jump {
    std::uint32_t target;
    double coupling, flow;
  };
  struct Row {
    std::vector<Jump> jumps;
    std::vector<Contact> contacts;
    std::array<double, 2 * D> clamped{};  // [1/m] sum over clamped partners of c_ij (d_j - d_i) towards each side
  };

  bool is_home(std::size_t voxel) const { return habitat_.home[places_.material[voxel]]; }
  bool is_clamped(std::size_t voxel) const { return habitat_.clamped[places_.material[voxel]]; }
  bool is_source(std::size_t voxel) const { return habitat_.source[places_.material[voxel]]; }
  double kernel_F(double r) const {
    return std::visit([r](const auto& k) { return k.F(r); }, kernel_);
  }
  double distance_to_side(std::size_t voxel, int side) const {
    const int a = side / 2;
    return side % 2 == 0 ? places_.position[voxel][a] - box_.lower[a] : box_.upper[a] - places_.position[voxel][a];
  }

  // Calls visit(place, voxel, x_ij, F_ij) for every particle or image within reach of voxel i, images of i included.
  template <class Visit>
  void each(std::size_t i, Visit visit) const {
    for (const std::uint32_t p : rows_.row(i)) {
      const base::Vec<D> x_ij = box_.nearest(mirrored_.position[i] - mirrored_.position[p]);
      visit(p, static_cast<std::size_t>(mirrored_.voxel[p]), x_ij, kernel_F(x_ij.norm()));
    }
  }

  void scale_all() {
    const std::size_t n = places_.position.size();
    scale_.assign(n, 0.0);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < n; ++i) {
      if (!is_home(i) && !is_clamped(i)) continue;
      double moment = 0.0;
      each(i, [&](std::uint32_t, std::size_t j, const base::Vec<D>& x_ij, double F) {
        const double weight = is_home(j) || is_clamped(j) ? 1.0 : 0.5;
        moment += weight * places_.area[j] * F * x_ij.squaredNorm() / D;
      });
      scale_[i] = moment > 0.0 ? 1.0 / moment : 0.0;
    }
  }

  Row kernel_row(std::size_t i) const {
    Row row;
    if (!is_home(i)) return row;
    row.jumps.reserve(rows_.row(i).size());
    each(i, [&](std::uint32_t p, std::size_t j, const base::Vec<D>& x_ij, double F) {
      if (!(mirrored_.crossed[p] & open_)) add(row, i, j, p, x_ij, (scale_[i] + scale_[j]) * places_.area[j] * F);
    });
    merge(row.jumps);
    add_surface(i, row);
    return row;
  }

  Row face_row(std::size_t i) const {
    Row row;
    if (!is_home(i)) return row;
    for (std::uint64_t f = cells_.first[i]; f < cells_.first[i + 1]; ++f) {
      const std::uint32_t j = cells_.target[f];
      const base::Vec<D> x_ij = box_.nearest(places_.position[i] - places_.position[j]);
      add(row, i, j, j, x_ij, cells_.weight[f] / places_.area[i]);
    }
    add_surface(i, row);
    return row;
  }

  void add(Row& row, std::size_t i, std::size_t j, std::uint32_t p, const base::Vec<D>& x_ij, double coupling) const {
    if (j == i || coupling <= 0.0) return;
    if (is_home(j)) {
      row.jumps.push_back({index(j), coupling, flow(i, j, p, x_ij, coupling)});
    } else if (is_clamped(j)) {
      row.contacts.push_back({index(i), 6u + places_.material[j], coupling, 0.0});
      for (int side = 0; side < 2 * D; ++side) row.clamped[std::size_t(side)] += coupling * away(i, j, side);
    }
  }

  // The share of a surface that releases a flux: 2 V_i |sum V_j grad W| over the particles of its material.
  void add_surface(std::size_t i, Row& row) const {
    if (!releases_) return;
    base::Vec<D> surface = base::Vec<D>::Zero();
    std::uint32_t source = 0;
    each(i, [&](std::uint32_t, std::size_t j, const base::Vec<D>& x_ij, double F) {
      if (!is_source(j)) return;
      surface -= places_.area[j] * F * x_ij;
      source = 6u + places_.material[j];
    });
    if (surface.norm() > 0.0)
      row.contacts.push_back({index(i), source, 0.0, 2.0 * places_.area[i] * surface.norm() * depth_});
  }

  // How much further from a side j stands than i [m]. An image counts with the distance of its particle: profiles are
  // even functions of the distance to a mirror.
  double away(std::size_t i, std::size_t j, int side) const {
    return distance_to_side(j, side) - distance_to_side(i, side);
  }

  double reach() const {
    return std::visit([](const auto& k) { return k.reach(); }, kernel_);
  }

  void add_side_contacts(std::size_t i, Row& row) const {
    for (int side = 0; side < 2 * D; ++side) {
      if (box_.periodic[static_cast<std::size_t>(side / 2)]) continue;
      const SideUse use = habitat_.side[static_cast<std::size_t>(side)];
      const double d = distance_to_side(i, side);
      if (use == SideUse::reflect || d >= reach()) continue;
      double sum = row.clamped[static_cast<std::size_t>(side)];
      for (const Jump& jump : row.jumps) sum += jump.coupling * away(i, jump.target, side);
      if (sum <= 0.0) continue;
      const auto boundary = static_cast<std::uint32_t>(side);
      if (use == SideUse::open)
        row.contacts.push_back({index(i), boundary, sum / d, 0.0});
      else
        row.contacts.push_back({index(i), boundary, 0.0, places_.area[i] * sum * depth_});
    }
  }

  // Volume carried from i to j [m^3/s]: s_ij F V_i V_j (dv_i + dv_j).x_ij, dv = transport minus fluid velocity.
  double flow(std::size_t i, std::size_t j, std::uint32_t p, const base::Vec<D>& x_ij, double coupling) const {
    if (places_.drift.empty()) return 0.0;
    if (!habitat_.carries[places_.material[i]] || !habitat_.carries[places_.material[j]]) return 0.0;
    base::Vec<D> other = places_.drift[j];
    for (int side = 0; side < 2 * D; ++side) {
      if (mirrored_.crossed[p] >> side & 1u) other[side / 2] = -other[side / 2];
    }
    return 0.5 * coupling * places_.area[i] * (places_.drift[i] + other).dot(x_ij) * depth_;
  }

  // A particle and its images are one target: add their couplings. Ascending by target, as whoever compares the rows of
  // two graphs expects.
  static void merge(std::vector<Jump>& jumps) {
    std::stable_sort(jumps.begin(), jumps.end(), [](const Jump& a, const Jump& b) { return a.target < b.target; });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < jumps.size(); ++k) {
      if (kept > 0 && jumps[kept - 1].target == jumps[k].target) {
        Jump& sum = jumps[kept - 1];
        sum.coupling += jumps[k].coupling;
        sum.flow += jumps[k].flow;
      } else {
        jumps[kept++] = jumps[k];
      }
    }
    jumps.resize(kept);
  }

  void append(const Row& row, HabitatGraph& result) const {
    for (const Jump& jump : row.jumps) {
      result.graph.target.push_back(jump.target);
      result.graph.coupling.push_back(jump.coupling);
      if (!places_.drift.empty()) result.graph.flow.push_back(jump.flow);
    }
    result.contacts.insert(result.contacts.end(), row.contacts.begin(), row.contacts.end());
  }

  // The shares of a flux side add up to its area exactly.
  void rescale_flux_areas(std::vector<Contact>& contacts) const {
    std::array<double, 6> sum{};
    for (const Contact& contact : contacts) {
      if (contact.boundary < 6) sum[contact.boundary] += contact.area;
    }
    for (Contact& contact : contacts) {
      if (contact.boundary >= 6 || contact.area == 0.0) continue;
      const double side_area = box_.volume() / box_.size()[contact.boundary / 2] * depth_;
      contact.area *= side_area / sum[contact.boundary];
    }
  }

  static std::uint32_t index(std::size_t i) { return static_cast<std::uint32_t>(i); }

  const Places<D>& places_;
  const base::Box<D>& box_;
  const sph::AnyKernel<D>& kernel_;
  double depth_;
  const Habitat& habitat_;
  std::uint8_t open_ = 0;
  bool releases_ = false;  // some material's surface does
  Mirrored<D> mirrored_;
  sph::NeighbourRows<D> rows_;
  std::vector<double> scale_;  // kernel weights only
  VoronoiCells cells_;         // face weights only
};

}  // namespace

template <int D>
HabitatGraph make_habitat_graph(const Places<D>& places, const base::Box<D>& box, const sph::AnyKernel<D>& kernel,
                                double depth, const Habitat& habitat, PairWeights weights) {
  return Builder<D>(places, box, kernel, depth, habitat).build(weights);
}

template HabitatGraph make_habitat_graph(const Places<1>&, const base::Box<1>&, const sph::AnyKernel<1>&, double,
                                         const Habitat&, PairWeights);
template HabitatGraph make_habitat_graph(const Places<2>&, const base::Box<2>&, const sph::AnyKernel<2>&, double,
                                         const Habitat&, PairWeights);
template HabitatGraph make_habitat_graph(const Places<3>&, const base::Box<3>&, const sph::AnyKernel<3>&, double,
                                         const Habitat&, PairWeights);

}  // namespace shmoo::rdme
