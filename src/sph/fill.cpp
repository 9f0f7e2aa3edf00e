#include "sph/fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/error.hpp"
#include "base/random.hpp"
#include "sph/fine_zone.hpp"

namespace shmoo::sph {
namespace {

template <int D>
using Index = std::array<long, D>;

// The lattice of a scene: how many particles along each axis, and how many layers beyond each side.
template <int D>
struct Lattice {
  Vec<D> lower, step;
  Index<D> inside{}, layers_low{}, layers_high{};

  Vec<D> place(const Index<D>& k) const {
    Vec<D> x;
    for (int a = 0; a < D; ++a) x[a] = lower[a] + (double(k[a]) + 0.5) * step[a];
    return x;
  }

  // Calls visit(index) for every point of the lattice, layers included, the first axis running fastest.
  template <class Visit>
  void each(Visit visit) const {
    Index<D> k;
    for (int a = 0; a < D; ++a) k[a] = -layers_low[a];
    while (true) {
      visit(k);
      int a = 0;
      while (a < D && ++k[a] == inside[a] + layers_high[a]) {
        k[a] = -layers_low[a];
        ++a;
      }
      if (a == D) return;
    }
  }
};

template <int D>
Lattice<D> make_lattice(const scene::Scene& scene, const base::Box<D>& box) {
  Lattice<D> lattice;
  lattice.lower = box.lower;
  for (int a = 0; a < D; ++a) {
    const double length = box.upper[a] - box.lower[a];
    lattice.inside[a] = std::max(1L, std::lround(length / scene.domain.spacing));
    lattice.step[a] = length / double(lattice.inside[a]);
    if (!scene.effects.flow) continue;
    const auto& sides = scene.domain.sides[std::size_t(a)];
    lattice.layers_low[a] = layers_beyond(sides[0].type, scene.numerics.reach);
    lattice.layers_high[a] = layers_beyond(sides[1].type, scene.numerics.reach);
  }
  return lattice;
}

bool opens(const scene::Domain& domain, int side) {
  return scene::is_open(domain.sides[std::size_t(side / 2)][std::size_t(side % 2)].type);
}

// The side of the domain that a lattice point stands beyond: 2 axis + side, or -1 inside. In corners walls go before
// open sides, and then the last axis rules.
template <int D>
int side_beyond(const scene::Domain& domain, const Lattice<D>& lattice, const Index<D>& k) {
  int side = -1;
  for (int a = 0; a < D; ++a) {
    const int beyond = k[a] < 0 ? 2 * a : k[a] >= lattice.inside[a] ? 2 * a + 1 : -1;
    if (beyond >= 0 && (side < 0 || !opens(domain, beyond))) side = beyond;
  }
  return side;
}

// The place inside the domain that is nearest to a lattice point.
template <int D>
Vec<D> place_inside(const Lattice<D>& lattice, Index<D> k) {
  for (int a = 0; a < D; ++a) k[a] = std::clamp(k[a], 0L, lattice.inside[a] - 1);
  return lattice.place(k);
}

template <int D>
struct Placed {
  Vec<D> x;
  std::uint16_t material;
  Role role;
  double share = 1.0;  // of a cell
};

template <int D>
int material_at(const scene::Scene& scene, const Vec<D>& x, std::vector<std::size_t>& received) {
  scene::Point point{};
  for (int a = 0; a < D; ++a) point[a] = x[a];
  for (std::size_t r = scene.regions.size(); r-- > 0;) {
    if (!scene::contains(*scene.regions[r].shape, point, D)) continue;
    ++received[r];
    return scene.regions[r].material;
  }
  return scene.domain.material;
}

Role role_of(scene::MaterialType type) {
  switch (type) {
    case scene::MaterialType::fluid:
      return Role::fluid;
    case scene::MaterialType::wall:
      return Role::wall;
    case scene::MaterialType::solid:
      return Role::solid;
    case scene::MaterialType::still:
      break;
  }
  return Role::still;
}

// What stands beyond an open side: the material at the side goes on.
template <int D>
std::optional<Placed<D>> beyond_opening(const scene::Scene& scene, const Lattice<D>& lattice, const Index<D>& k) {
  std::vector<std::size_t> received(scene.regions.size(), 0);
  const int material = material_at(scene, place_inside<D>(lattice, k), received);
  if (material < 0) return std::nullopt;
  const auto& what = scene.materials[std::size_t(material)];
  if (what.type == scene::MaterialType::solid)
    throw base::InputError(fmt::format("the solid '{}' reaches an open side of the domain; keep it inside", what.name));
  const Role role = what.type == scene::MaterialType::fluid ? Role::open : role_of(what.type);
  return Placed<D>{lattice.place(k), static_cast<std::uint16_t>(material), role};
}

// Places for those that may enter before as many have left: 3 % of all and four layers of the cross-section.
template <int D>
std::size_t reserve_places(const scene::Scene& scene, const Lattice<D>& lattice, std::size_t voxels) {
  std::size_t layer = 0;
  for (int a = 0; a < D; ++a) {
    const auto& sides = scene.domain.sides[std::size_t(a)];
    if (!scene::is_open(sides[0].type) && !scene::is_open(sides[1].type)) continue;
    layer = 1;
    for (int b = 0; b < D; ++b) layer *= b == a ? 1 : std::size_t(lattice.inside[b]);
  }
  return layer == 0 ? 0 : voxels * 3 / 100 + 4 * layer;
}

// Those that are split before as many have been merged: a quarter of the fine ones.
template <int D>
std::size_t reserve_for_splits(const std::vector<Placed<D>>& inside) {
  return std::size_t(std::count_if(inside.begin(), inside.end(), [](const auto& one) { return one.share < 1.0; })) / 4;
}

// Calls visit(index, place, share of a cell) for every point of the lattice, or the fine ones in its place.
template <int D, class Visit>
void each_place(const scene::Scene& scene, const Lattice<D>& lattice, Visit visit) {
  if (scene.domain.refinements.empty())
    return lattice.each([&](const Index<D>& k) { visit(k, lattice.place(k), 1.0); });
  const FineZone<D> zone(scene);
  lattice.each([&](const Index<D>& k) {
    const Vec<D> x = lattice.place(k);
    if (!(zone.depth(place_inside<D>(lattice, k)) > 0.0)) return visit(k, x, 1.0);
    for (unsigned corner = 0; corner < 1U << D; ++corner) {
      Vec<D> way = 0.25 * lattice.step;
      for (int a = 0; a < D; ++a)
        if ((corner >> a & 1U) == 0) way[a] = -way[a];
      visit(k, Vec<D>(x + way), 1.0 / (1U << D));
    }
  });
}

// Puts what was placed into the store, the displaced ones where chance takes them.
template <int D>
void store(const scene::Scene& scene, const std::vector<Placed<D>>& all, Filling<D>& filling) {
  auto& particles = filling.particles;
  particles.resize(all.size());
  auto* share = scene.domain.refinements.empty() ? nullptr : &particles.template require<double>("share", "1");
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Placed<D>& placed = all[i];
    particles.position[i] = placed.x;
    particles.id[i] = static_cast<std::uint32_t>(i);
    particles.material[i] = placed.material;
    particles.role[i] = placed.role;
    if (share) (*share)[i] = placed.share;
    if (placed.role == Role::wall || placed.role == Role::open || scene.domain.jitter == 0.0) continue;
    base::RandomSequence random({scene.run.seed, 0}, base::Stream::placement, 0, static_cast<std::uint32_t>(i));
    const double jitter = scene.domain.jitter * (placed.share == 1.0 ? 1.0 : std::pow(placed.share, 1.0 / D));
    for (int a = 0; a < D; ++a)
      particles.position[i][a] += (2.0 * random.uniform() - 1.0) * jitter * filling.spacing[a];
    particles.position[i] = filling.box.wrap(particles.position[i]);
  }
}

template <int D>
void refuse_empty(const scene::Scene& scene, const Filling<D>& filling, const std::vector<std::size_t>& received) {
  std::vector<base::Diagnostic> mistakes;
  for (std::size_t r = 0; r < received.size(); ++r) {
    if (received[r] > 0) continue;
    const auto& name = scene.materials[static_cast<std::size_t>(scene.regions[r].material)].name;
    mistakes.push_back({scene.regions[r].where,
                        fmt::format("this region of '{}' received no particle at a spacing of {:g} m; make the spacing "
                                    "smaller, the region larger, or do not cover it by a later region",
                                    name, scene.domain.spacing)});
  }
  std::vector<std::size_t> population(scene.materials.size(), 0);
  for (std::size_t i = 0; i < filling.voxels; ++i) ++population[filling.particles.material[i]];
  for (const auto& species : scene.species) {
    const auto lives = [&](int home) { return population[static_cast<std::size_t>(home)] > 0; };
    for (const int home : species.homes) {
      if (lives(home)) continue;
      mistakes.push_back(
          {species.where,
           fmt::format("species '{}' lives in '{}', which received no particle; fill it with a region or "
                       "make the spacing smaller",
                       species.name, scene.materials[static_cast<std::size_t>(home)].name)});
    }
  }
  if (filling.voxels == 0) {
    mistakes.push_back({{scene.file, 0, 0}, "the domain holds no particle; name domain.material or add a region"});
  }
  if (!mistakes.empty()) throw base::InputError(std::move(mistakes));
}

}  // namespace

long layers_beyond(scene::SideType type, double reach) {
  if (scene::has_friction(type)) return static_cast<long>(std::ceil(reach));
  // Fluid that is half a spacing and a bit beyond the side still has its whole support.
  return scene::is_open(type) ? static_cast<long>(std::ceil(reach)) + 2 : 0;
}

template <int D>
base::Box<D> domain_box(const scene::Domain& domain) {
  base::Box<D> box;
  for (int a = 0; a < D; ++a) {
    box.lower[a] = domain.lower[a];
    box.upper[a] = domain.upper[a];
    box.periodic[a] = domain.sides[a][0].type == scene::SideType::periodic;
  }
  return box;
}

template <int D>
Filling<D> fill(const scene::Scene& scene) {
  Filling<D> filling;
  filling.box = domain_box<D>(scene.domain);
  const auto lattice = make_lattice<D>(scene, filling.box);
  filling.spacing = lattice.step;
  filling.cell = lattice.step.prod();
  std::vector<Placed<D>> inside, beyond;
  std::vector<std::size_t> received(scene.regions.size(), 0);
  each_place<D>(scene, lattice, [&](const Index<D>& k, const Vec<D>& x, double share) {
    const int side = side_beyond<D>(scene.domain, lattice, k);
    if (side >= 0 && opens(scene.domain, side)) {
      if (const auto placed = beyond_opening<D>(scene, lattice, k)) beyond.push_back(*placed);
      return;
    }
    if (side >= 0) {
      beyond.push_back({x, side_material(scene.materials.size(), side / 2, side % 2), Role::wall, share});
      return;
    }
    const int material = material_at(scene, x, received);
    if (material < 0) {
      filling.vacant.push_back(x);
      return;
    }
    const auto type = scene.materials[static_cast<std::size_t>(material)].type;
    inside.push_back({x, static_cast<std::uint16_t>(material), role_of(type), share});
  });
  filling.voxels = inside.size();
  filling.reserve = reserve_places<D>(scene, lattice, filling.voxels) + reserve_for_splits<D>(inside);
  for (std::size_t a = 0; a < D; ++a)
    for (std::size_t side = 0; side < 2; ++side)
      filling.mirrors[a][side] = scene.domain.sides[a][side].type == scene::SideType::slip;
  inside.insert(inside.end(), beyond.begin(), beyond.end());
  store(scene, inside, filling);
  refuse_empty(scene, filling, received);
  return filling;
}

template Filling<1> fill(const scene::Scene&);
template Filling<2> fill(const scene::Scene&);
template Filling<3> fill(const scene::Scene&);
template base::Box<1> domain_box(const scene::Domain&);
template base::Box<2> domain_box(const scene::Domain&);
template base::Box<3> domain_box(const scene::Domain&);

}  // namespace shmoo::sph
