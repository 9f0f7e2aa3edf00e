// The sides of the domain.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

constexpr std::array<std::pair<const char*, SideType>, 6> side_types{{{"periodic", SideType::periodic},
                                                                      {"wall", SideType::wall},
                                                                      {"reflect", SideType::reflect},
                                                                      {"slip", SideType::slip},
                                                                      {"inlet", SideType::inlet},
                                                                      {"outlet", SideType::outlet}}};

// The type that a key of this table names, if any.
Side side_of_type(const Section& section, std::string_view key) {
  Side side;
  read_choice(section, key, side_types, side.type);
  return side;
}

void read_slide(const Section& section, int axis, Side& side) {
  const auto* list = section.good("velocity");
  for (const auto& entry : *list->as_array())
    if (!looks_like_quantity(entry.value_or(std::string())))
      return section.error("velocity", "a wall slides with a constant velocity: give quantities, no formulas");
  side.velocity = point_of(*list);
  if (side.velocity[static_cast<std::size_t>(axis)] != 0)
    section.error("velocity", fmt::format("a side slides along itself; its {} component must be 0",
                                          axis_names[static_cast<std::size_t>(axis)]));
}

void read_side(const Section& sides, const std::string& key, int axis, Side& side) {
  const auto* node = sides.good(key);
  if (!node) return;
  const auto section = sides.section(key);
  side = section ? side_of_type(*section, "type") : side_of_type(sides, key);
  if (!section || !section->good("type")) return;
  if (section->has("pressure") && !is_open(side.type))
    section->error("pressure", "only an inlet or an outlet holds a pressure");
  if (section->good("velocity") && side.type == SideType::wall)
    read_slide(*section, axis, side);
  else if (section->has("velocity") && side.type != SideType::wall && side.type != SideType::inlet)
    section->error("velocity", "only a side of type \"wall\" slides, and only an \"inlet\" says what enters");
  if (section->has("species") && !is_open(side.type))
    section->error("species",
                   "only what enters through an inlet or an outlet holds species; see [[boundary]] for others");
  side.pressure = section->quantity("pressure");
}

void read_inflow(const Section& section, const Draft& draft, int axis, int end, Side& side) {
  if (section.has("velocity") == section.has("pressure"))
    return section.error("an inlet has either a 'velocity' or a 'pressure'");
  const auto* list = section.good("velocity");
  if (!list || !list->is_array()) return;
  side.inflow = velocity_formulas(draft, section, "velocity", *list, true);
  const auto& inward = side.inflow[static_cast<std::size_t>(axis)];
  const bool wrong = inward.expression.empty() && (end == 0 ? inward.value <= 0 : inward.value >= 0);
  if (wrong)
    section.error("velocity",
                  fmt::format("what enters moves into the domain; its {} component must be {}",
                              axis_names[static_cast<std::size_t>(axis)], end == 0 ? "positive" : "negative"));
}

void read_species(const Section& section, const Scene& scene, Side& side) {
  const auto given = section.section("species");
  if (!given) return;
  for (const auto& [key, value] : given->table()) {
    const int species = species_index(scene, std::string(key.str()), *given, key.str(), value);
    const auto concentration = given->quantity(key.str());
    if (species < 0 || !concentration) continue;
    const auto& homes = scene.species[static_cast<std::size_t>(species)].homes;
    const bool flows = std::any_of(homes.begin(), homes.end(), [&](int home) {
      return scene.materials[static_cast<std::size_t>(home)].type == MaterialType::fluid;
    });
    if (!flows) given->error(key.str(), "does not live in the fluid, so it cannot enter with it");
    side.species.emplace_back(species, *concentration);
  }
}

// What an open side does not go together with.
void check_open(const Section& sides, const Scene& scene, const std::string& key, int axis) {
  for (int other = 0; other < axis; ++other)
    for (const Side& side : scene.domain.sides[static_cast<std::size_t>(other)])
      if (is_open(side.type)) return sides.error(key, "open sides must all be on one axis; make this one \"slip\"");
  if (!scene.species.empty() && scene.numerics.steady_tolerance)
    sides.error(key, "a steady flow that is carried lets no species in and out; remove numerics.steady_tolerance");
  if (has_solids(scene) && quasi_static(scene)) sides.error(key, "a quasi-static scene has no flow; remove it");
  int fluids = 0;
  for (const auto& material : scene.materials) fluids += material.type == MaterialType::fluid ? 1 : 0;
  if (fluids > 1) sides.error(key, "what enters is of one fluid, and this scene has several; give it one");
}

}  // namespace

void build_sides(const Section& domain, Scene& scene) {
  auto& all = scene.domain.sides;
  if (domain.text("boundary"))
    for (auto& pair : all) pair.fill(side_of_type(domain, "boundary"));
  const auto sides = domain.section("boundary");
  if (!sides) return;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name(1, axis_names[static_cast<std::size_t>(axis)]);
    auto& [lower, upper] = all[static_cast<std::size_t>(axis)];
    for (const std::string& key : {name, name + "_min", name + "_max"})
      if (axis >= scene.dimension && sides->has(key))
        sides->error(key, fmt::format("a scene of dimension {} has no axis {}; remove it", scene.dimension, name));
    read_side(*sides, name, axis, lower);
    upper = lower;
    read_side(*sides, name + "_min", axis, lower);
    read_side(*sides, name + "_max", axis, upper);
    if ((lower.type == SideType::periodic) != (upper.type == SideType::periodic))
      sides->error(sides->has(name + "_min") ? name + "_min" : name + "_max",
                   fmt::format("an axis is periodic at both ends or at none; write {} = \"periodic\"", name));
  }
}

void build_openings(const Section& root, Draft& draft) {
  const auto domain = root.section("domain");
  const auto sides = domain ? domain->section("boundary") : std::nullopt;
  if (!sides) return;
  for (int axis = 0; axis < draft.dimension; ++axis) {
    const std::string name(1, axis_names[static_cast<std::size_t>(axis)]);
    for (int end = 0; end < 2; ++end) {
      Side& side = draft.domain.sides[static_cast<std::size_t>(axis)][static_cast<std::size_t>(end)];
      if (!is_open(side.type)) continue;
      const std::string own = name + (end == 0 ? "_min" : "_max"), key = sides->has(own) ? own : name;
      check_open(*sides, draft, key, axis);
      const auto section = sides->section(key);
      if (side.type == SideType::inlet && section) read_inflow(*section, draft, axis, end, side);
      if (section) read_species(*section, draft, side);
      if (side.type == SideType::outlet && !side.pressure) side.pressure = 0.0;
    }
  }
}

}  // namespace shmoo::scene
