// Inflow zones and what drives the fluid.
#include <fmt/format.h>

#include "base/constants.hpp"
#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

ShapePointer build_zone(const Section& inflow, const Scene& scene) {
  const auto zone = inflow.section("zone");
  if (!zone) return nullptr;
  BoxShape box{scene.domain.lower, scene.domain.upper};
  bool good = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, axis_names[axis]);
    if (!zone->has(name)) continue;
    const auto range = zone->quantities(name);
    const auto fail = [&](const std::string& message) {
      zone->error(name, message);
      good = false;
    };
    if (static_cast<int>(axis) >= scene.dimension)
      fail(fmt::format("a scene of dimension {} has no axis {}; remove it", scene.dimension, name));
    else if (range.size() != 2)
      good = false;
    else if (range[0] >= range[1])
      fail("must begin below its end");
    else if (range[1] <= box.lower[axis] || range[0] >= box.upper[axis])
      fail("lies outside the domain");
    else
      box.lower[axis] = range[0], box.upper[axis] = range[1];
  }
  return good ? std::make_shared<const Shape>(Shape{box}) : nullptr;
}

void read_targets(const Section& section, const Scene& scene, Inflow& inflow) {
  const auto targets = section.section("species");
  if (!targets) return;
  for (const auto& [key, value] : targets->table()) {
    const int species = species_index(scene, std::string(key.str()), *targets, key.str(), value);
    const auto concentration = targets->quantity(key.str());
    if (species >= 0 && concentration) inflow.species.emplace_back(species, *concentration);
  }
}

void build_buoyancy(const Section& root, Draft& draft) {
  for (const auto& section : root.sections("buoyancy")) {
    Buoyancy buoyancy;
    if (const auto name = section.text("species"))
      buoyancy.species = species_index(draft, *name, section, "species", *section.find("species"));
    buoyancy.expansion = section.quantity("expansion").value_or(0);
    buoyancy.reference = section.quantity("reference").value_or(0);
    if (has_open_sides(draft)) section.error("does not go together with open sides of the domain yet; use walls");
    if (draft.flow.gravity == Point{}) section.error("nothing weighs; give flow.gravity");
    if (draft.numerics.steady_tolerance)
      section.error("the flow follows its species and is never carried; remove numerics.steady_tolerance");
    if (buoyancy.species >= 0) draft.flow.buoyancy.push_back(buoyancy);
  }
}

}  // namespace

std::vector<Quantity> velocity_formulas(const Draft& draft, const Section& section, std::string_view key,
                                        const toml::node& list, bool timed) {
  std::vector<Quantity> formulas;
  for (const auto& entry : *list.as_array()) {
    const auto text = entry.value_or(std::string());
    if (looks_like_quantity(text)) {
      formulas.push_back({quantity_of(entry), ""});
      continue;
    }
    check_formula(draft, section, key, entry, base::dimensions::speed, timed ? Reads::time : Reads::place);
    formulas.push_back({0, expanded(draft, text)});
  }
  return formulas;
}

void build_inflows(const Section& root, Draft& draft) {
  for (const auto& section : root.sections("inflow")) {
    Inflow inflow;
    inflow.zone = build_zone(section, draft);
    inflow.velocity = section.point("velocity");
    inflow.relaxation_time = section.quantity("relaxation_time");
    inflow.ramp_exponent = static_cast<int>(section.integer("ramp_exponent").value_or(0));
    read_targets(section, draft, inflow);
    if (!section.has("velocity") && !section.has("species"))
      section.error("it does nothing; give 'velocity', 'species' or both");
    if (inflow.ramp_exponent > 0 && !section.has("velocity"))
      section.error("ramp_exponent", "the ramp rises along the velocity, so give 'velocity' too, or remove it");
    draft.inflows.push_back(std::move(inflow));
  }
}

void build_flow(const Section& root, Draft& draft) {
  const auto section = root.section("flow");
  if (!section) return build_buoyancy(root, draft);
  Flow& flow = draft.flow;
  flow.body_force = section->point("body_force");
  if (const auto* list = section->good("initial_velocity"); list && list->is_array())
    flow.initial_velocity = velocity_formulas(draft, *section, "initial_velocity", *list);
  flow.gravity = section->point("gravity").value_or(Point{});
  flow.reference_speed = section->quantity("reference_speed");
  flow.reference_length = section->quantity("reference_length");
  flow.sound_speed = section->quantity("sound_speed");
  flow.density_variation = section->number("density_variation").value_or(flow.density_variation);
  flow.background_pressure = section->quantity("background_pressure").value_or(0);
  flow.thermal_energy = section->quantity("thermal_energy");
  if (section->has("temperature") && section->has("thermal_energy"))
    section->error("thermal_energy", "give either 'temperature' or 'thermal_energy', not both");
  else if (const auto temperature = section->quantity("temperature"))
    flow.thermal_energy = base::boltzmann * *temperature;
  build_buoyancy(root, draft);
  if (section->has("gravity") && flow.buoyancy.empty())
    section->error("gravity", "acts on [[buoyancy]] only, and there is none; a body_force acts on the whole fluid");
}

}  // namespace shmoo::scene
