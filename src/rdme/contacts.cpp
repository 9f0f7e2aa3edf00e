#include "rdme/contacts.hpp"

namespace shmoo::rdme {
namespace {

template <int D>
class Contacts {
 public:
  Contacts(const Surroundings<D>& around, JumpGraph&& graph) : around_(around), graph_(std::move(graph)) {
    const auto any = [](const std::vector<bool>& list) { return std::ranges::find(list, true) != list.end(); };
    clamps_ = any(around.habitat.clamped);
    releases_ = any(around.habitat.source);
  }

  HabitatGraph make() {
    std::uint64_t kept = 0, begin = 0;
    for (std::size_t i = 0; i < around_.size(); ++i) {
      const std::uint64_t end = graph_.first[i + 1], first = kept;
      std::array<double, 2 * D> clamped{};
      kept = clamps_ ? keep_jumps(i, begin, end, kept, clamped) : end;
      begin = end;
      graph_.first[i + 1] = kept;
      if (!around_.is_home(i)) continue;
      if (releases_) add_surface(i);
      add_sides(i, first, clamped);
    }
    graph_.target.resize(kept);
    graph_.coupling.resize(kept);
    if (!graph_.flow.empty()) graph_.flow.resize(kept);
    rescale_flux_areas();
    return {std::move(graph_), std::move(contacts_)};
  }

 private:
  // Moves the jumps of a row to `to` and on, all but those to clamped voxels, which become contacts. `clamped` [1/m] by
  // side: the sum over clamped partners of c_ij (d_j - d_i).
  std::uint64_t keep_jumps(std::size_t i, std::uint64_t begin, std::uint64_t end, std::uint64_t to,
                           std::array<double, 2 * D>& clamped) {
    const std::uint64_t first = to;
    const std::size_t before = contacts_.size();
    for (std::uint64_t p = begin; p < end; ++p) {
      const std::uint32_t j = graph_.target[p];
      if (around_.is_clamped(j)) {
        contacts_.push_back({std::uint32_t(i), 6u + around_.places.material[j], graph_.coupling[p], 0.0});
        for (int side = 0; side < 2 * D; ++side) clamped[std::size_t(side)] += graph_.coupling[p] * away(i, j, side);
        continue;
      }
      graph_.target[to] = j;
      graph_.coupling[to] = graph_.coupling[p];
      if (!graph_.flow.empty()) graph_.flow[to] = graph_.flow[p];
      ++to;
    }
    if (contacts_.size() > before && around_.surface) meet_surface(i, first, to, before);
    return to;
  }

  // Where all contacts of voxel i from `before` on are with one smooth surface, one contact with that in their place.
  // Not where jumps lead through a wall thinner than the reach: no one surface tells distances on both of its sides.
  void meet_surface(std::size_t i, std::uint64_t first, std::uint64_t end, std::size_t before) {
    const std::uint32_t boundary = contacts_[before].boundary;
    for (std::size_t k = before; k < contacts_.size(); ++k)
      if (contacts_[k].boundary != boundary) return;
    const auto& position = around_.places.position;
    const auto& surface = *around_.surface;
    const auto foot = surface.nearest_from_fluid(position[i], around_.reach());
    if (!foot || surface.material_at(foot->place - 1e-3 * least_ * foot->normal) != int(boundary) - 6) return;
    if (!surface.smooth_about(*foot, around_.reach())) return;
    if (foot->curvature * around_.reach() <= -1.0) return;  // a hollow's centre, where harmonic() has no end, is near
    const auto height = [&](std::size_t j) {
      return foot->harmonic(foot->distance(around_.box.nearest(position[j] - foot->place)));
    };
    const double own = height(i);
    double sum = 0.0;
    for (std::uint64_t p = first; p < end; ++p) {
      const double other = height(graph_.target[p]);
      if (!(other > -0.2 * around_.reach())) return;
      sum += graph_.coupling[p] * (other - own);
    }
    contacts_.resize(before);
    if (sum > 0.0) contacts_.push_back({std::uint32_t(i), boundary, sum / std::max(own, least_), 0.0});
  }

  // The share of a surface that releases a flux: 2 V_i |sum V_j grad W| over the particles of its material.
  void add_surface(std::size_t i) {
    base::Vec<D> surface = base::Vec<D>::Zero();
    std::uint32_t source = 0;
    around_.each(i, [&](std::size_t j, unsigned, const base::Vec<D>& x_ij, double F) {
      if (!around_.is_source(j)) return;
      surface -= around_.places.area[j] * F * x_ij;
      source = 6u + around_.places.material[j];
    });
    const double size = surface.norm();
    if (size > 0.0)
      contacts_.push_back({std::uint32_t(i), source, 0.0, 2.0 * around_.places.area[i] * size * around_.depth});
  }

  // How much further from a side j stands than i [m]. An image counts with the distance of its particle: profiles are
  // even functions of the distance to a mirror.
  double away(std::size_t i, std::size_t j, int side) const {
    return around_.distance_to_side(j, side) - around_.distance_to_side(i, side);
  }

  void add_sides(std::size_t i, std::uint64_t first, const std::array<double, 2 * D>& clamped) {
    for (int side = 0; side < 2 * D; ++side) {
      if (!around_.has_side(side)) continue;
      const SideUse use = around_.habitat.side[std::size_t(side)];
      const double d = around_.distance_to_side(i, side);
      if (use == SideUse::reflect || d >= around_.reach()) continue;
      double sum = clamped[std::size_t(side)];
      for (std::uint64_t p = first; p < graph_.first[i + 1]; ++p)
        sum += graph_.coupling[p] * away(i, graph_.target[p], side);
      if (sum <= 0.0) continue;
      if (use == SideUse::open)
        contacts_.push_back({std::uint32_t(i), std::uint32_t(side), sum / d, 0.0});
      else
        contacts_.push_back({std::uint32_t(i), std::uint32_t(side), 0.0, around_.places.area[i] * sum * around_.depth});
    }
  }

  // The shares of a flux side add up to its area exactly.
  void rescale_flux_areas() {
    std::array<double, 6> sum{};
    for (const Contact& contact : contacts_)
      if (contact.boundary < 6) sum[contact.boundary] += contact.area;
    for (Contact& contact : contacts_) {
      if (contact.boundary >= 6 || contact.area == 0.0) continue;
      const double side_area = around_.box.volume() / around_.box.size()[contact.boundary / 2] * around_.depth;
      contact.area *= side_area / sum[contact.boundary];
    }
  }

  const Surroundings<D>& around_;
  JumpGraph graph_;
  std::vector<Contact> contacts_;
  bool clamps_ = false, releases_ = false;
  // [m] what stands nearer to a surface counts as standing so far: rates must stay finite
  const double least_ = 0.02 * around_.reach();
};

}  // namespace

template <int D>
HabitatGraph with_contacts(const Surroundings<D>& around, JumpGraph graph) {
  return Contacts<D>(around, std::move(graph)).make();
}

template HabitatGraph with_contacts(const Surroundings<1>&, JumpGraph);
template HabitatGraph with_contacts(const Surroundings<2>&, JumpGraph);
template HabitatGraph with_contacts(const Surroundings<3>&, JumpGraph);

}  // namespace shmoo::rdme
