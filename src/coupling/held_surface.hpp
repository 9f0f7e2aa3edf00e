#pragma once
// The true surface at which a habitat meets materials that are held at a concentration.
#include <optional>

#include "rdme/jump_graph.hpp"
#include "scene/scene.hpp"
#include "sph/surface.hpp"

namespace shmoo::coupling {

// None where nothing is held, or where what is held moves: it is no longer where its regions say. The scene must
// outlive the surface.
template <int D>
std::optional<sph::Surface<D>> held_surface(const scene::Scene& scene, const rdme::Habitat& habitat);

extern template std::optional<sph::Surface<1>> held_surface(const scene::Scene&, const rdme::Habitat&);
extern template std::optional<sph::Surface<2>> held_surface(const scene::Scene&, const rdme::Habitat&);
extern template std::optional<sph::Surface<3>> held_surface(const scene::Scene&, const rdme::Habitat&);

}  // namespace shmoo::coupling
