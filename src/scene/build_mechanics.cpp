// How solids move, and what species do to them.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "scene/build.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

int species_of(const Section& section, const Scene& scene) {
  const auto name = section.text("species");
  return name ? species_index(scene, *name, section, "species", *section.find("species")) : -1;
}

// What acts on a wall must live in it.
bool lives_in(const Section& section, const Scene& scene, int species, int material) {
  if (species < 0) return false;
  const auto& one = scene.species[std::size_t(species)];
  if (std::find(one.homes.begin(), one.homes.end(), material) != one.homes.end()) return true;
  const auto& name = scene.materials[std::size_t(material)].name;
  section.error("species", fmt::format("{} does not live in {}; add it to species.{}.in", one.name, name, one.name));
  return false;
}

void read_growth(const Section& section, Scene& scene, int material) {
  Growth growth;
  growth.species = species_of(section, scene);
  growth.coefficient = section.quantity("coefficient").value_or(0);
  growth.yield_stress = section.quantity("yield_stress").value_or(0);
  if (lives_in(section, scene, growth.species, material))
    scene.materials[std::size_t(material)].elastic->growth = growth;
}

void read_sources(const Section& mechanics, Scene& scene) {
  for (const auto& section : mechanics.sections("source")) {
    TipSource source;
    source.species = species_of(section, scene);
    source.rate = section.quantity("rate").value_or(0);
    source.concentration = section.quantity("concentration").value_or(0);
    source.width = section.quantity("width").value_or(0);
    if (source.species >= 0) scene.mechanics.sources.push_back(source);
  }
}

void refuse_keys_of_quasi_static(const Section& section) {
  for (const char* key : {"turgor", "step", "tolerance", "columns", "source"})
    if (section.has(key))
      section.error(key, "only quasi-static motion has it; set motion = \"quasi-static\", or remove it");
}

}  // namespace

void build_mechanics(const Section& root, Scene& scene) {
  auto& mechanics = scene.mechanics;
  if (const auto section = root.section("mechanics")) {
    read_choice(*section, "motion",
                std::array<std::pair<const char*, Motion>, 2>{
                    {{"dynamic", Motion::dynamic}, {"quasi-static", Motion::quasi_static}}},
                mechanics.motion);
    if (!quasi_static(scene))
      refuse_keys_of_quasi_static(*section);
    else if (!section->has("turgor"))
      section->error("turgor", "missing; quasi-static motion needs the pressure in the cavity");
    mechanics.turgor = section->quantity("turgor").value_or(0);
    mechanics.step = section->quantity("step");
    mechanics.tolerance = section->number("tolerance").value_or(mechanics.tolerance);
    mechanics.columns = static_cast<int>(section->integer("columns").value_or(0));
  }
  scene.axisymmetric = root.boolean("axisymmetric").value_or(false);
  if (scene.axisymmetric && !quasi_static(scene))
    root.error("axisymmetric",
               "only quasi-static mechanics knows it; set mechanics.motion = \"quasi-static\", or remove it");
  if (scene.axisymmetric && scene.dimension != 2) root.error("axisymmetric", "needs dimension = 2");
}

void build_wall(const Section& root, Scene& scene) {
  for (const auto& [name, section] : root.named_sections("materials")) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
      if (scene.materials[m].name != name || !scene.materials[m].elastic) continue;
      const auto growth = section.section("growth");
      if (growth && !quasi_static(scene))
        section.error("growth", "needs mechanics.motion = \"quasi-static\"; set it, or remove this");
      if (growth) read_growth(*growth, scene, int(m));
    }
  }
  if (const auto mechanics = root.section("mechanics")) read_sources(*mechanics, scene);
}

}  // namespace shmoo::scene
