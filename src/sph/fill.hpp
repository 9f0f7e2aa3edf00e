#pragma once
// Placing the particles of a scene: a lattice of the wanted spacing over the domain, later regions over earlier ones,
// and where the fluid moves, layers of particles beyond its sides: walls, or, beyond open sides, what stands inside
// goes on. Periodic sides and mirrors have none.
#include <array>

#include "base/box.hpp"
#include "scene/scene.hpp"
#include "sph/particles.hpp"

namespace shmoo::sph {

template <int D>
struct Filling {
  Particles<D> particles;  // where there are fine ones, with a column `share`, what each fills [cells]
  base::Box<D> box;
  base::Vec<D> spacing;              // [m] per axis: the extent divided by a whole number of particles
  std::size_t voxels = 0;            // particles inside the domain: ids 0 .. voxels-1
  double cell = 0;                   // [m^D] what one particle fills on the lattice, a coarse one where spacings differ
  std::vector<base::Vec<D>> vacant;  // [m] lattice points inside the domain that no region fills
  std::size_t reserve = 0;           // places for particles that enter or are split, above the voxels; mostly 0
  std::array<std::array<bool, 2>, D> mirrors{};  // [axis][side] at which the fluid slips
};

// How many layers of particles stand beyond a side of this type where the fluid moves.
long layers_beyond(scene::SideType type, double reach);

template <int D>
base::Box<D> domain_box(const scene::Domain& domain);

// Throws base::InputError where a region or the home of a species receives no particle, or the whole domain stays
// empty.
template <int D>
Filling<D> fill(const scene::Scene& scene);

extern template Filling<1> fill(const scene::Scene&);
extern template Filling<2> fill(const scene::Scene&);
extern template Filling<3> fill(const scene::Scene&);
extern template base::Box<1> domain_box(const scene::Domain&);
extern template base::Box<2> domain_box(const scene::Domain&);
extern template base::Box<3> domain_box(const scene::Domain&);

}  // namespace shmoo::sph
