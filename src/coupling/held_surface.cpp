#include "coupling/held_surface.hpp"

namespace shmoo::coupling {
namespace {

bool moves(const scene::Scene& scene, const scene::Material& material) {
  if (material.type == scene::MaterialType::fluid) return scene.effects.flow;
  return material.motion || material.type == scene::MaterialType::solid;
}

}  // namespace

// Fluids mix, so where the habitat is one of them all that are not held count as inside.
template <int D>
std::optional<sph::Surface<D>> held_surface(const scene::Scene& scene, const rdme::Habitat& habitat) {
  bool holds = false, in_fluid = false;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (habitat.clamped[m] && moves(scene, scene.materials[m])) return std::nullopt;
    holds = holds || habitat.clamped[m];
    in_fluid = in_fluid || (habitat.home[m] && scene.materials[m].type == scene::MaterialType::fluid);
  }
  if (!holds) return std::nullopt;
  std::vector<bool> inside = habitat.home;
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    if (in_fluid && scene.materials[m].type == scene::MaterialType::fluid && !habitat.clamped[m]) inside[m] = true;
  return std::optional<sph::Surface<D>>(std::in_place, scene, std::move(inside));
}

template std::optional<sph::Surface<1>> held_surface(const scene::Scene&, const rdme::Habitat&);
template std::optional<sph::Surface<2>> held_surface(const scene::Scene&, const rdme::Habitat&);
template std::optional<sph::Surface<3>> held_surface(const scene::Scene&, const rdme::Habitat&);

}  // namespace shmoo::coupling
