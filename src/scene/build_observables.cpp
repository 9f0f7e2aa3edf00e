#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/build.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

// What an observable needs and may say.
struct TypeRules {
  const char* name;
  ObservableType type;
  bool species = false, flow = false;  // of which it needs one
  bool axis = false, component = false;
  bool line = false;      // at points of a line
  bool boundary = false;  // at a side or at a material's surface
  bool solid = false;     // belongs to solids
  bool wall = false;      // belongs to a quasi-static wall
};

constexpr std::array types{
    TypeRules{.name = "count", .type = ObservableType::count, .species = true},
    TypeRules{.name = "concentration", .type = ObservableType::concentration, .species = true},
    TypeRules{.name = "profile", .type = ObservableType::profile, .species = true, .axis = true},
    TypeRules{.name = "kinetic_energy", .type = ObservableType::kinetic_energy, .flow = true},
    TypeRules{.name = "max_speed", .type = ObservableType::max_speed, .flow = true},
    TypeRules{.name = "temperature", .type = ObservableType::temperature, .flow = true},
    TypeRules{.name = "density_error", .type = ObservableType::density_error, .flow = true},
    TypeRules{.name = "min_distance", .type = ObservableType::min_distance, .flow = true},
    TypeRules{.name = "bounces", .type = ObservableType::bounces, .flow = true},
    TypeRules{.name = "velocity_profile",
              .type = ObservableType::velocity_profile,
              .flow = true,
              .axis = true,
              .component = true},
    TypeRules{.name = "velocity_line",
              .type = ObservableType::velocity_line,
              .flow = true,
              .axis = true,
              .component = true,
              .line = true},
    TypeRules{
        .name = "species_line", .type = ObservableType::species_line, .species = true, .axis = true, .line = true},
    TypeRules{
        .name = "wall_force", .type = ObservableType::wall_force, .flow = true, .component = true, .boundary = true},
    TypeRules{
        .name = "wall_torque", .type = ObservableType::wall_torque, .flow = true, .component = true, .boundary = true},
    TypeRules{.name = "species_flux", .type = ObservableType::species_flux, .species = true, .boundary = true},
    TypeRules{.name = "displacement", .type = ObservableType::displacement, .component = true, .solid = true},
    TypeRules{.name = "elastic_energy", .type = ObservableType::elastic_energy, .solid = true},
    TypeRules{.name = "solid_energy", .type = ObservableType::solid_energy, .solid = true},
    TypeRules{.name = "projection_length", .type = ObservableType::projection_length, .wall = true},
    TypeRules{.name = "tip_curvature", .type = ObservableType::tip_curvature, .wall = true},
    TypeRules{.name = "flank_curvature", .type = ObservableType::flank_curvature, .wall = true},
    TypeRules{.name = "cavity_volume", .type = ObservableType::cavity_volume, .wall = true},
    TypeRules{.name = "residual", .type = ObservableType::residual, .wall = true},
    TypeRules{.name = "outside", .type = ObservableType::outside, .wall = true}};

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

void refuse(const Section& section, std::initializer_list<const char*> keys, const TypeRules& rules) {
  for (const char* key : keys)
    if (section.has(key))
      section.error(key, fmt::format("an observable of type \"{}\" has none; remove it", rules.name));
}

// Of quasi-static walls, and what such scenes do not have.
void read_wall(const Section& section, const Scene& scene, const TypeRules& rules) {
  if (rules.wall && !quasi_static(scene))
    section.error("type", fmt::format("\"{}\" belongs to a wall with mechanics.motion = \"quasi-static\"; remove the "
                                      "observable",
                                      rules.name));
  if (rules.wall) refuse(section, {"species", "in", "shape"}, rules);
  if (quasi_static(scene) && !rules.flow && (rules.solid || rules.line || rules.boundary))
    section.error("type", fmt::format("\"{}\" is not measured where mechanics.motion is \"quasi-static\"; remove the "
                                      "observable",
                                      rules.name));
}

void read_species(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (!rules.species) {
    refuse(section, {"species"}, rules);
    return;
  }
  if (!section.has("species"))
    return section.error("species",
                         fmt::format("missing; an observable of type \"{}\" needs the name of a species", rules.name));
  const auto name = section.text("species");
  if (name) observable.species = species_index(scene, *name, section, "species", *section.find("species"));
}

// The material in which, or at whose surface, something is measured.
void read_material(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (!rules.species && !rules.boundary) return refuse(section, {"in"}, rules);
  if (const auto material = section.text("in"))
    observable.material = material_index(scene, *material, section, "in", *section.find("in"));
  if (rules.boundary || observable.species < 0 || observable.material < 0) return;
  const auto& species = scene.species[static_cast<std::size_t>(observable.species)];
  if (std::find(species.homes.begin(), species.homes.end(), observable.material) == species.homes.end())
    section.error("in",
                  fmt::format("{} does not live there; add the material to species.{}.in", species.name, species.name));
}

void read_boundary(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (!rules.boundary) return refuse(section, {"side"}, rules);
  const auto side = section.text("side");
  if (side.has_value() == section.has("in"))
    return section.error(fmt::format("an observable of type \"{}\" needs either 'side' or 'in'", rules.name));
  if (side) {
    const auto axis = static_cast<int>(axis_names.find((*side)[0]));
    observable.side = 2 * axis + (side->ends_with("max") ? 1 : 0);
    const auto& of = scene.domain.sides[static_cast<std::size_t>(axis)][side->ends_with("max") ? 1 : 0];
    if (axis >= scene.dimension || of.type == SideType::periodic)
      section.error("side", "this scene has no such side; it is periodic or beyond its dimensions");
    else if (rules.flow && !has_friction(of.type))
      section.error("side", "is open or a mirror, so no wall is there on which the fluid acts");
    else if (is_open(of.type))
      section.error("side", "is open: species pass it with the fluid, and the ledger counts them");
  } else if (rules.flow && observable.material >= 0 &&
             scene.materials[static_cast<std::size_t>(observable.material)].type == MaterialType::fluid) {
    section.error("in", "is a fluid; name a wall on which the fluid acts");
  }
}

void read_line(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  const bool about = observable.type == ObservableType::wall_torque;
  if (!rules.line) refuse(section, {"at"}, rules);
  const std::string_view key = about ? "about" : "through";
  if (!about) refuse(section, {"about"}, rules);
  if (!rules.line) refuse(section, {"through"}, rules);
  if (!rules.line && !about) return;
  if (!section.has(key))
    return section.error(key, about ? "missing; a torque acts about a point" : "missing; give a point of the line");
  observable.point = section.point(key).value_or(Point{});
  if (!rules.line) return;
  observable.at = section.quantities("at");
  if (!std::is_sorted(observable.at.begin(), observable.at.end(), std::less_equal<>()))
    section.error("at", "must ascend, without repetition");
  const auto axis = static_cast<std::size_t>(std::min(observable.axis, 2));
  if (!observable.at.empty() &&
      (observable.at.front() < scene.domain.lower[axis] || observable.at.back() > scene.domain.upper[axis]))
    section.error("at", "holds points outside the domain");
  if (section.has("at") && section.has("bins")) section.error("bins", "give either 'at' or 'bins', not both");
}

void read_profile(const Section& section, const Scene& scene, const TypeRules& rules, Observable& observable) {
  if (!rules.axis) {
    for (const char* key : {"axis", "bins"})
      if (section.has(key)) section.error(key, "only a profile or a line has it; remove it");
  } else {
    observable.axis = read_axis(section, "axis", scene.dimension);
    const auto axis = static_cast<std::size_t>(std::min(observable.axis, 2));
    const double length = scene.domain.upper[axis] - scene.domain.lower[axis];
    const double spacings = scene.domain.spacing > 0 ? std::round(length / scene.domain.spacing) : 1;
    observable.bins =
        static_cast<int>(section.integer("bins").value_or(static_cast<std::int64_t>(std::clamp(spacings, 1.0, 1e6))));
  }
  if (rules.component)
    observable.component = read_axis(section, "component", scene.dimension);
  else if (section.has("component"))
    section.error("component", "only a velocity, a displacement, a force or a torque has it; remove it");
}

}  // namespace

void build_observables(const Section& root, Scene& scene) {
  for (const auto& section : root.sections("observable")) {
    Observable observable;
    read_name(section, scene, observable);
    const auto type = section.text("type");
    const auto rules = std::find_if(types.begin(), types.end(), [&](const TypeRules& one) { return type == one.name; });
    if (rules == types.end()) continue;
    observable.type = rules->type;
    if (section.has("shape")) {
      if (rules->line || rules->boundary) refuse(section, {"shape"}, *rules);
      observable.shape = build_shape(section, scene.dimension);
    }
    if (!scene.compartments.empty() && (rules->axis || rules->flow || rules->boundary || rules->solid || rules->wall)) {
      section.error("type",
                    fmt::format("\"{}\" belongs to space, which a well-mixed scene has none of; use \"count\" or "
                                "\"concentration\"",
                                *type));
      continue;
    }
    if (rules->flow && !scene.effects.flow)
      section.error("type", fmt::format("\"{}\" belongs to a moving fluid, and effects.flow is off; remove the "
                                        "observable",
                                        rules->name));
    read_wall(section, scene, *rules);
    if (rules->wall) {
      // it is all of the wall's
    } else if (rules->solid) {
      read_solid(section, scene, *rules, observable);
    } else {
      read_species(section, scene, *rules, observable);
      read_material(section, scene, *rules, observable);
    }
    read_boundary(section, scene, *rules, observable);
    read_profile(section, scene, *rules, observable);
    read_line(section, scene, *rules, observable);
    scene.observables.push_back(std::move(observable));
  }
}

}  // namespace shmoo::scene
