#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/build.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

struct TypeRules {
  const char* name;
  ObservableType type;
  bool species, profile;  // needs a species; runs along an axis
  bool solid = false;     // belongs to solids
};

constexpr std::array types{TypeRules{"count", ObservableType::count, true, false},
                           TypeRules{"concentration", ObservableType::concentration, true, false},
                           TypeRules{"profile", ObservableType::profile, true, true},
                           TypeRules{"kinetic_energy", ObservableType::kinetic_energy, false, false},
                           TypeRules{"max_speed", ObservableType::max_speed, false, false},
                           TypeRules{"temperature", ObservableType::temperature, false, false},
                           TypeRules{"density_error", ObservableType::density_error, false, false},
                           TypeRules{"min_distance", ObservableType::min_distance, false, false},
                           TypeRules{"velocity_profile", ObservableType::velocity_profile, false, true},
                           TypeRules{"displacement", ObservableType::displacement, false, false, true},
                           TypeRules{"elastic_energy", ObservableType::elastic_energy, false, false, true},
                           TypeRules{"solid_energy", ObservableType::solid_energy, false, false, true}};

constexpr std::size_t longest_name = 64;

bool is_observable_name(const std::string& name) {
  return !name.empty() && name.size() <= longest_name && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

int read_axis(const Section& section, std::string_view key, int dimension) {
  const auto name = section.text(key);
  if (!name) return 0;
  const int axis = static_cast<int>(axis_names.find(*name));
  if (axis >= dimension) section.error(key, fmt::format("a scene of dimension {} has no axis {}", dimension, *name));
  return axis;
}

void read_name(const Section& section, const Scene& scene, Observable& observable) {
  const auto name = section.text("name");
  if (!name) return;
  observable.name = *name;
  if (!is_observable_name(*name))
    section.error("name",
                  fmt::format("{} is no name; use up to {} letters, digits, _ and -", quoted(*name), longest_name));
  for (const auto& other : scene.observables)
    if (other.name == *name)
      return section.error("name", fmt::format("{} is taken by another observable; choose another", quoted(*name)));
}

void read_solid(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (!has_solids(scene))
    section.error("type",
                  fmt::format("\"{}\" belongs to a solid, and no material is one; remove the observable", rules.name));
  if (section.has("species")) section.error("species", "a solid's motion has none; remove it");
  if (const auto material = section.text("in"))
    observable.material = material_index(scene, *material, section, "in", *section.find("in"));
  if (observable.material >= 0 &&
      scene.materials[static_cast<std::size_t>(observable.material)].type != MaterialType::solid)
    section.error("in", "is not a solid; name one");
  if (observable.type == ObservableType::displacement) return;
  for (const char* key : {"in", "shape"})
    if (section.has(key)) section.error(key, "energies are those of all solids; remove it");
}

void read_species(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (rules.solid) return read_solid(section, scene, rules, observable);
  if (!rules.species) {
    for (const char* key : {"species", "in"})
      if (section.has(key))
        section.error(key, fmt::format("an observable of type \"{}\" belongs to the fluid; remove it", rules.name));
    if (!scene.effects.flow)
      section.error(
          "type",
          fmt::format("\"{}\" belongs to a moving fluid, and effects.flow is off; remove the observable", rules.name));
    return;
  }
  if (!section.has("species"))
    return section.error("species",
                         fmt::format("missing; an observable of type \"{}\" needs the name of a species", rules.name));
  const auto name = section.text("species");
  if (name) observable.species = species_index(scene, *name, section, "species", *section.find("species"));
  if (const auto material = section.text("in"))
    observable.material = material_index(scene, *material, section, "in", *section.find("in"));
  if (observable.species < 0 || observable.material < 0) return;
  const auto& homes = scene.species[static_cast<std::size_t>(observable.species)].homes;
  if (std::find(homes.begin(), homes.end(), observable.material) == homes.end())
    section.error("in", fmt::format("{} does not live there; add the material to species.{}.in", *name, *name));
}

void read_profile(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (!rules.profile) {
    for (const char* key : {"axis", "bins"})
      if (section.has(key)) section.error(key, "only a profile has it; remove it");
  } else {
    observable.axis = read_axis(section, "axis", scene.dimension);
    const auto axis = static_cast<std::size_t>(std::min(observable.axis, 2));
    const double length = scene.domain.upper[axis] - scene.domain.lower[axis];
    const double spacings = scene.domain.spacing > 0 ? std::round(length / scene.domain.spacing) : 1;
    observable.bins =
        static_cast<int>(section.integer("bins").value_or(static_cast<std::int64_t>(std::clamp(spacings, 1.0, 1e6))));
  }
  if (observable.type == ObservableType::velocity_profile || observable.type == ObservableType::displacement)
    observable.component = read_axis(section, "component", scene.dimension);
  else if (section.has("component"))
    section.error("component", "only a velocity profile or a displacement has it; remove it");
}

}  // namespace

void build_observables(const Section& root, Scene& scene) {
  for (const auto& section : root.sections("observable")) {
    Observable observable;
    read_name(section, scene, observable);
    if (section.has("shape")) observable.shape = build_shape(section, scene.dimension);
    const auto type = section.text("type");
    const auto rules = std::find_if(types.begin(), types.end(), [&](const TypeRules& one) { return type == one.name; });
    if (rules == types.end()) continue;
    observable.type = rules->type;
    if (!scene.compartments.empty() && (rules->profile || !rules->species)) {
      section.error("type",
                    fmt::format("\"{}\" belongs to space, which a well-mixed scene has none of; use \"count\" or "
                                "\"concentration\"",
                                *type));
      continue;
    }
    read_species(section, scene, *rules, observable);
    read_profile(section, scene, *rules, observable);
    scene.observables.push_back(std::move(observable));
  }
}

}  // namespace shmoo::scene
