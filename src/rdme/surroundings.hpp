#pragma once
// What jump graphs of one habitat are made from: the particles, their neighbours, and the mirror images beyond sides
// that are not periodic. An image of a particle is never closer than the particle itself, so whatever has an image
// within reach is a neighbour; only a particle's own images are not in its row.
#include <algorithm>
#include <cmath>

#include "rdme/jump_graph.hpp"
#include "sph/neighbours.hpp"

namespace shmoo::rdme {

template <int D>
struct Surroundings {
  using Vec = base::Vec<D>;

  const Places<D>& places;
  const base::Box<D>& box;
  const sph::AnyKernel<D>& kernel;
  double depth;
  const Habitat& habitat;
  const sph::NeighbourRows<D>& rows;  // of all pairs within the kernel's reach, and perhaps some beyond
  const sph::Surface<D>* surface;     // of the habitat; null: only its particles tell where it ends

  std::size_t size() const { return places.position.size(); }
  bool is_home(std::size_t i) const { return habitat.home[places.material[i]]; }
  bool is_clamped(std::size_t i) const { return habitat.clamped[places.material[i]]; }
  bool is_source(std::size_t i) const { return habitat.source[places.material[i]]; }
  bool is_open(int side) const { return habitat.side[std::size_t(side)] == SideUse::open; }
  bool has_side(int side) const { return !box.periodic[std::size_t(side / 2)]; }
  double reach() const {
    return std::visit([](const auto& k) { return k.reach(); }, kernel);
  }
  double distance_to_side(std::size_t i, int side) const {
    const int a = side / 2;
    return side % 2 == 0 ? places.position[i][a] - box.lower[a] : box.upper[a] - places.position[i][a];
  }
  bool near_side(std::size_t i) const {
    for (int side = 0; side < 2 * D; ++side)
      if (has_side(side) && distance_to_side(i, side) < reach()) return true;
    return false;
  }
  Vec separation(std::size_t i, std::size_t j) const { return box.nearest(places.position[i] - places.position[j]); }

  // Calls visit(crossed, x_ij) for every image of j in one side of each of some axes; bit `side` of crossed is set
  // where it was mirrored in that side. Those out of reach may be among them.
  template <class Visit>
  void each_image(std::size_t i, std::size_t j, Visit visit) const {
    std::array<double, 3 * D> along;  // [m] x_ij by axis: to j itself, to its image beyond the lower and the upper side
    for (int a = 0; a < D; ++a) {
      const double x_i = places.position[i][a], x_j = places.position[j][a];
      along[std::size_t(3 * a)] = x_i - x_j;
      along[std::size_t(3 * a + 1)] = x_i - (2.0 * box.lower[a] - x_j);
      along[std::size_t(3 * a + 2)] = x_i - (2.0 * box.upper[a] - x_j);
    }
    constexpr int all = D == 1 ? 3 : D == 2 ? 9 : 27;
    for (int combination = 1; combination < all; ++combination) {
      unsigned crossed = 0;
      bool exists = true;
      Vec x_ij;
      for (int a = 0, rest = combination; a < D; ++a, rest /= 3) {
        const int choice = rest % 3;
        exists = exists && (choice == 0 || !box.periodic[std::size_t(a)]);
        if (choice > 0) crossed |= 1u << (2 * a + choice - 1);
        x_ij[a] = along[std::size_t(3 * a + choice)];
      }
      if (exists) visit(crossed, box.nearest(x_ij));
    }
  }

  // Calls visit(j, crossed, x_ij, F_ij) for every particle and image within reach of i, its own images included.
  template <class Visit>
  void each(std::size_t i, Visit visit) const {
    const bool mirrored = near_side(i);
    const auto look = [&](std::size_t j, unsigned crossed, const Vec& x_ij) {
      const double F = std::visit([&](const auto& k) { return k.F(x_ij.norm()); }, kernel);
      if (F > 0.0) visit(j, crossed, x_ij, F);
    };
    const auto images = [&](std::size_t j) {
      each_image(i, j, [&](unsigned crossed, const Vec& x_ij) { look(j, crossed, x_ij); });
    };
    for (const std::uint32_t j : rows.row(i)) {
      look(j, 0u, separation(i, j));
      if (mirrored) images(j);
    }
    if (mirrored) images(i);
  }

  // Volume carried from i to j or its image [m^3/s]: s_ij F V_i V_j (dv_i + dv_j).x_ij, dv = transport minus fluid
  // velocity.
  double flow(std::size_t i, std::size_t j, unsigned crossed, const Vec& x_ij, double coupling) const {
    if (!habitat.carries[places.material[i]] || !habitat.carries[places.material[j]]) return 0.0;
    Vec other = places.drift[j];
    for (int side = 0; side < 2 * D; ++side)
      if (crossed >> side & 1u) other[side / 2] = -other[side / 2];
    return 0.5 * coupling * places.area[i] * (places.drift[i] + other).dot(x_ij) * depth;
  }
};

}  // namespace shmoo::rdme
