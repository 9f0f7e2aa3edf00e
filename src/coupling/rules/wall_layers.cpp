#include <algorithm>
#include <cmath>

#include "coupling/rules/limits.hpp"
#include "scene/refinement.hpp"
#include "sph/fill.hpp"
#include "sph/fine_zone.hpp"

namespace shmoo::coupling {
namespace {

// What stands on the points of the starting lattice, layers beyond the sides included.
template <int D>
class Occupation {
 public:
  using Index = std::array<long, D>;

  explicit Occupation(const sph::Filling<D>& filling) : filling_(filling) {
    lowest_.fill(0);
    Index highest = lowest_;
    for (const auto& x : filling.particles.position.values()) {
      const Index k = index_of(x);
      for (std::size_t a = 0; a < D; ++a) {
        lowest_[a] = std::min(lowest_[a], k[a]);
        highest[a] = std::max(highest[a], k[a]);
      }
    }
    std::size_t size = 1;
    for (std::size_t a = 0; a < D; ++a) size *= std::size_t(extent_[a] = highest[a] - lowest_[a] + 1);
    solid_.assign(size, false);
    for (std::size_t i = 0; i < filling.particles.size(); ++i)
      solid_[place(index_of(filling.particles.position[i]))] = filling.particles.role[i] != sph::Role::fluid;
  }

  Index index_of(const base::Vec<D>& x) const {
    Index k;
    for (int a = 0; a < D; ++a)
      k[std::size_t(a)] = std::lround((x[a] - filling_.box.lower[a]) / filling_.spacing[a] - 0.5);
    return k;
  }

  // Nothing stands beyond the lattice; through periodic sides it goes on.
  bool solid(Index k) const {
    for (std::size_t a = 0; a < D; ++a) {
      if (filling_.box.periodic[int(a)]) k[a] = ((k[a] % extent_[a]) + extent_[a]) % extent_[a];
      if (k[a] < lowest_[a] || k[a] >= lowest_[a] + extent_[a]) return false;
    }
    return solid_[place(k)];
  }

 private:
  std::size_t place(const Index& k) const {
    std::size_t at = 0;
    for (std::size_t a = D; a-- > 0;) at = at * std::size_t(extent_[a]) + std::size_t(k[a] - lowest_[a]);
    return at;
  }

  const sph::Filling<D>& filling_;
  Index lowest_{}, extent_{};
  std::vector<bool> solid_;
};

// Where spacings differ: the scene at the fine one everywhere, with twice as many layers beyond the sides.
scene::Scene all_fine(scene::Scene scene) {
  if (!scene::refined(scene)) return scene;
  scene.domain.refinements.clear();
  scene.domain.spacing *= 0.5;
  scene.numerics.reach *= 2.0;
  return scene;
}

// From every fluid particle along every axis: how many solids follow each other, where the first neighbour is one.
template <int D>
double thinnest(const scene::Scene& scene) {
  const scene::Scene fine = all_fine(scene);
  const sph::FineZone<D> zone(scene);
  const auto in_own_spacings = [&](long layers, const base::Vec<D>& x) {
    return scene::refined(scene) && !(zone.depth(x) > 0.0) ? 0.5 * double(layers) : double(layers);
  };
  const auto filling = sph::fill<D>(fine);
  const Occupation<D> occupation(filling);
  const long enough = std::lround(std::ceil(fine.numerics.reach));
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < filling.particles.size(); ++i) {
    if (filling.particles.role[i] != sph::Role::fluid) continue;
    for (int way = 0; way < 2 * D; ++way) {
      long layers = 0;
      auto next = occupation.index_of(filling.particles.position[i]);
      for (; layers < enough; ++layers) {
        next[std::size_t(way / 2)] += way % 2 == 0 ? 1 : -1;
        if (!occupation.solid(next)) break;
      }
      if (layers > 0) least = std::min(least, in_own_spacings(layers, filling.particles.position[i]));
    }
  }
  return least;
}

}  // namespace

double thinnest_wall(const scene::Scene& scene) {
  if (scene.dimension == 2) return thinnest<2>(scene);
  if (scene.dimension == 3) return thinnest<3>(scene);
  return std::numeric_limits<double>::infinity();
}

}  // namespace shmoo::coupling
