// The surface that a reaction runs on: two materials, between which its species are divided.
#include <fmt/format.h>

#include "scene/build.hpp"
#include "scene/surface.hpp"

namespace shmoo::scene {
namespace {

bool divides(const Section& section, const Scene& scene, const std::array<int, 2>& surface, const Term& term) {
  const Species& species = scene.species[static_cast<std::size_t>(term.species)];
  const auto name = [&](int side) {
    return scene.materials[static_cast<std::size_t>(surface[std::size_t(side)])].name;
  };
  const bool first = lives_in(species, surface[0]), second = lives_in(species, surface[1]);
  if (first != second) return true;
  section.error("surface",
                fmt::format("{} lives in {} {} and {}, so it is not clear where it takes part; a species of a surface "
                            "reaction lives in just one of them",
                            species.name, first ? "both" : "neither", name(0), name(1)));
  return false;
}

}  // namespace

bool read_surface(const Section& section, const Scene& scene, Reaction& reaction) {
  const auto names = section.names("surface");
  if (names.size() != 2) return false;
  std::array<int, 2> surface;
  for (std::size_t side = 0; side < 2; ++side)
    surface[side] = material_index(scene, names[side].first, section, "surface", *names[side].second);
  if (surface[0] < 0 || surface[1] < 0) return false;
  if (surface[0] == surface[1]) {
    section.error("surface", "names one material twice; a surface is where two materials meet");
    return false;
  }
  if (section.has("rate") || section.has("in")) {
    section.error(section.has("rate") ? "rate" : "in",
                  "is not for a reaction on a surface; give rate constants as 'forward' and 'backward'");
    return false;
  }
  for (const auto* side : {&reaction.reactants, &reaction.products})
    for (const Term& term : *side)
      if (!divides(section, scene, surface, term)) return false;
  reaction.surface = surface;
  return true;
}

}  // namespace shmoo::scene
