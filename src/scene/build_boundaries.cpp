// What species do at sides of the domain and at surfaces of materials.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <tuple>

#include "base/units.hpp"
#include "scene/build.hpp"

namespace shmoo::scene {
namespace {

struct Place {
  int axis = -1, side = 0, material = -1;
};

std::optional<Place> side_named(const std::string& name) {
  if (name.size() != 5 || (!name.ends_with("_min") && !name.ends_with("_max"))) return std::nullopt;
  const auto axis = axis_names.find(name.front());
  if (axis == std::string_view::npos) return std::nullopt;
  return Place{static_cast<int>(axis), name.ends_with("_max") ? 1 : 0, -1};
}

std::optional<Place> place_named(const std::string& name, const toml::node& at, const Section& section,
                                 const Scene& scene) {
  const auto place = side_named(name);
  if (!place) {
    std::vector<std::string> names;
    for (int axis = 0; axis < scene.dimension; ++axis)
      for (const char* end : {"_min", "_max"})
        names.push_back(axis_names[static_cast<std::size_t>(axis)] + std::string(end));
    for (std::size_t i = 0; i < scene.materials.size(); ++i) {
      if (scene.materials[i].name == name) return Place{-1, 0, static_cast<int>(i)};
      names.push_back(scene.materials[i].name);
    }
    section.error(at, "at",
                  fmt::format("no side or material is called {}{}", quoted(name),
                              suggestion(name, names, fmt::format("places: {}", listed(names)))));
    return std::nullopt;
  }
  if (place->axis >= scene.dimension) {
    section.error(at, "at", fmt::format("a scene of dimension {} has no side {}", scene.dimension, name));
    return std::nullopt;
  }
  const auto& side = scene.domain.sides[static_cast<std::size_t>(place->axis)][static_cast<std::size_t>(place->side)];
  if (side.type == SideType::periodic) {
    section.error(at, "at",
                  fmt::format("{} is periodic, so nothing ends there; make the axis \"wall\" or \"reflect\"", name));
    return std::nullopt;
  }
  if (is_open(side.type)) {
    section.error(at, "at",
                  fmt::format("fluid passes {}, and species with it; say what enters by 'species' of that side in "
                              "domain.boundary",
                              name));
    return std::nullopt;
  }
  return place;
}

BoundaryType type_named(const std::string& name) {
  if (name == "fixed") return BoundaryType::fixed;
  if (name == "flux") return BoundaryType::flux;
  return name == "absorb" ? BoundaryType::absorb : BoundaryType::reflect;
}

double read_value(const Section& section, BoundaryType type, const std::string& name) {
  const bool needed = type == BoundaryType::fixed || type == BoundaryType::flux;
  if (!needed) {
    if (section.has("value"))
      section.error("value", fmt::format("a boundary of type \"{}\" takes none; remove it", name));
    return 0;
  }
  const auto wanted = type == BoundaryType::fixed ? base::dimensions::concentration : base::dimensions::flux;
  if (!section.has("value")) section.error("value", fmt::format("missing; expected {}", base::expectation(wanted)));
  const auto text = section.text("value");
  if (!text) return 0;
  const auto measured = base::parse_quantity(*text);
  if (measured.dimension != wanted)
    section.error("value", fmt::format("{} is {}; a boundary of type \"{}\" expects {}", quoted(*text),
                                       base::dimension_name(measured.dimension), name, base::expectation(wanted)));
  return measured.value;
}

bool same_place(const SpeciesBoundary& a, const SpeciesBoundary& b) {
  return std::tie(a.species, a.axis, a.side, a.material) == std::tie(b.species, b.axis, b.side, b.material);
}

void add_boundary(const Section& section, Scene& scene, const SpeciesBoundary& boundary, const toml::node& at) {
  const auto& species = scene.species[static_cast<std::size_t>(boundary.species)];
  const bool inside = boundary.material >= 0 &&
                      std::find(species.homes.begin(), species.homes.end(), boundary.material) != species.homes.end();
  if (inside)
    return section.error(
        at, "at",
        fmt::format("{} lives in {} itself, so that surface does not bound it; take it out of species.{}.in, "
                    "or name another place",
                    species.name, scene.materials[static_cast<std::size_t>(boundary.material)].name, species.name));
  const bool twice = std::any_of(scene.boundaries.begin(), scene.boundaries.end(),
                                 [&](const auto& other) { return same_place(boundary, other); });
  if (twice)
    return section.error(at, "at", fmt::format("{} has a boundary there already; keep one of them", species.name));
  scene.boundaries.push_back(boundary);
}

}  // namespace

void build_boundaries(const Section& root, Scene& scene) {
  for (const auto& section : root.sections("boundary")) {
    const auto type = section.text("type");
    SpeciesBoundary boundary;
    boundary.where = section.where();
    if (type) {
      boundary.type = type_named(*type);
      boundary.value = read_value(section, boundary.type, *type);
    }
    std::vector<std::pair<Place, const toml::node*>> places;
    for (const auto& [name, node] : section.names("at"))
      if (const auto place = place_named(name, *node, section, scene)) places.emplace_back(*place, node);
    for (const auto& [name, node] : section.names("species")) {
      boundary.species = species_index(scene, name, section, "species", *node);
      if (boundary.species < 0 || !type) continue;
      for (const auto& [place, at] : places) {
        boundary.axis = place.axis;
        boundary.side = place.side;
        boundary.material = place.material;
        add_boundary(section, scene, boundary, *at);
      }
    }
  }
}

}  // namespace shmoo::scene
