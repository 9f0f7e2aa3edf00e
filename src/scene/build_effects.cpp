// Which effects are on: what the file asks for, what follows from it, and whether the data for it are there.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/motion.hpp"

namespace shmoo::scene {
namespace {

constexpr std::span of_flow = std::span(effect_keys).subspan(1);  // all but the flow itself

// A table that is absent answers as an empty one.
class Asked {
 public:
  explicit Asked(const Section& root) : root_(root), section_(root.section("effects")) {}
  bool has(std::string_view key) const { return section_ && section_->has(key); }
  std::optional<bool> value(std::string_view key) const { return section_ ? section_->boolean(key) : std::nullopt; }
  bool automatic(std::string_view key) const {
    return section_ && section_->text(section_->has(key) ? key : "default") == "auto";
  }
  void error(std::string_view key, const std::string& message) const {
    if (section_)
      section_->error(key, message);
    else
      root_.error("effects", message);
  }

 private:
  const Section& root_;
  std::optional<Section> section_;
};

// What sets the fluid in motion, or "".
std::string driver(const Scene& scene, const Asked& asked) {
  if (asked.value("flow") == true) return "effects.flow";
  for (std::size_t i = 0; i < scene.inflows.size(); ++i)
    if (scene.inflows[i].velocity) return fmt::format("inflow.{}.velocity", i);
  if (scene.flow.body_force) return "flow.body_force";
  if (!scene.flow.buoyancy.empty()) return "buoyancy";
  if (!scene.flow.initial_velocity.empty()) return "flow.initial_velocity";
  for (const auto& material : scene.materials)
    if (material.type == MaterialType::wall && (material.motion || material.surface_motion))
      return fmt::format("the moving wall {}", material.name);
  const auto of_type = [&](MaterialType type) {
    return std::find_if(scene.materials.begin(), scene.materials.end(),
                        [&](const Material& material) { return material.type == type; });
  };
  const auto solid = of_type(MaterialType::solid);
  if (solid != scene.materials.end() && of_type(MaterialType::fluid) != scene.materials.end())
    return fmt::format("the solid {}", solid->name);
  for (const auto& axis : scene.domain.sides)
    for (const auto& side : axis)
      if (side.velocity != Point{} || is_open(side.type))
        return is_open(side.type) ? "an open side of the domain" : "a sliding side of the domain";
  if (asked.automatic("thermal_noise") && scene.flow.thermal_energy) return "flow.temperature";
  return asked.value("thermal_noise") == true ? "effects.thermal_noise" : "";
}

// A flow has one fluid: materials of that type may differ in what lives there, not in how they flow.
void check_one_fluid(const Scene& scene, const Section& section, const Material*& first) {
  for (const Material& material : scene.materials) {
    if (section.path() != join_path("materials", material.name)) continue;
    if (!first) first = &material;
    if (material.density != first->density || material.viscosity != first->viscosity ||
        material.bulk_viscosity != first->bulk_viscosity)
      section.error(fmt::format(
          "differs from {} in density or viscosity; a flow has one fluid, so give both the same values", first->name));
  }
}

// What a flow needs; each thing that is missing is reported where it belongs.
void check_flow_data(const Section& root, const Scene& scene, const std::string& why) {
  if (scene.dimension == 1)
    root.error(
        "dimension",
        fmt::format("a flow (because of {}) needs 2 or 3 dimensions; set effects.flow = false to leave it out", why));
  bool fluid = false;
  const Material* first = nullptr;
  for (const auto& [name, section] : root.named_sections("materials")) {
    if (section.text("type") != "fluid") continue;
    fluid = true;
    for (const char* key : {"density", "viscosity"})
      if (!section.has(key))
        section.error(
            key,
            fmt::format("missing; the flow (because of {}) needs it; set effects.flow = false to leave the flow out",
                        why));
    if (section.good("density") && section.good("viscosity")) check_one_fluid(scene, section, first);
    // The friction across a pair's line is proportional to viscosity - bulk_viscosity/2 (2-D), 5/3 viscosity -
    // bulk_viscosity (3-D); Espanol and Revenga 2003.
    const double limit = (scene.dimension == 2 ? 2.0 : 5.0 / 3.0) * section.quantity("viscosity").value_or(0);
    if (section.good("viscosity") && section.quantity("bulk_viscosity").value_or(0) > limit)
      section.error("bulk_viscosity", fmt::format("must not exceed {} times the viscosity in {} dimensions",
                                                  scene.dimension == 2 ? "2" : "5/3", scene.dimension));
  }
  if (!fluid && !scene.materials.empty())
    root.error("materials", fmt::format("a flow (because of {}) needs a material of type \"fluid\"", why));
}

bool has_walls(const Scene& scene) {
  const bool sides = std::any_of(scene.domain.sides.begin(), scene.domain.sides.end(), [](const auto& axis) {
    return axis[0].type == SideType::wall || axis[1].type == SideType::wall;
  });
  return sides || std::any_of(scene.materials.begin(), scene.materials.end(), [](const Material& material) {
           return material.type == MaterialType::wall || material.type == MaterialType::solid;
         });
}

// Below this many spacings the kernel's sums are no longer those of a fluid.
constexpr double least_reach = 1.5;

void check_requests(const Asked& asked, const Scene& scene) {
  const auto needs = [&](const char* effect, bool given, const char* what) {
    if (asked.value(effect) == true && !given) asked.error(effect, what);
  };
  needs("bounce_back", has_walls(scene), "there are no walls to turn particles back; remove it");
  needs("closed_room", !has_open_sides(scene), "fluid passes an open side of the domain; remove it");
  needs("species_advection", !scene.species.empty(), "there are no species to carry; remove it");
  needs("thermal_noise", scene.flow.thermal_energy.has_value(), "needs flow.temperature or flow.thermal_energy");
  needs("thermal_noise", asked.value("viscosity") != false,
        "needs the viscosity that it balances; remove effects.viscosity = false");
  for (const auto& axis : scene.domain.sides)
    for (const auto& side : axis)
      needs("thermal_noise", !is_open(side.type) && side.type != SideType::slip,
            "has no law for open and slip sides yet; make the domain periodic or give it walls");
  needs("transport_velocity", asked.value("thermal_noise") != true,
        "shifts particles in a way that does not keep the temperature (2-D: 3 % low); remove it, noise alone keeps "
        "them apart");
}

}  // namespace

void build_effects(const Section& root, Scene& scene) {
  const Asked asked(root);
  const std::string why = driver(scene, asked);
  Effects& effects = scene.effects;
  effects.flow = asked.value("flow").value_or(!why.empty());
  for (const auto& [name, on] : effect_keys)
    if (asked.automatic(name)) scene.undecided.push_back(on);
  if (!effects.flow) {
    if (has_open_sides(scene))
      asked.error("flow", "fluid passes an open side of the domain; remove flow = false, or make the side \"reflect\"");
    if (why.starts_with("the solid"))
      asked.error("flow", fmt::format("{} moves in a fluid, which then moves too; remove flow = false, or make the "
                                      "fluid a still material",
                                      why));
    for (const auto& [name, member] : of_flow) {
      if (asked.value(name) == true) asked.error(name, "needs effects.flow, which is off");
      effects.*member = false;
    }
    return;
  }
  check_flow_data(root, scene, why);
  if (has_open_sides(scene) && acts_back(scene) && scene.flow.buoyancy.empty())
    root.error("materials",
               "solids that species soften do not go together with open sides of the domain yet; use a "
               "periodic axis and an [[inflow]] zone");
  if (const auto numerics = root.section("numerics"); numerics && scene.numerics.reach < least_reach)
    numerics->error("reach",
                    fmt::format("a flow (because of {}) needs a reach of at least {} spacings", why, least_reach));
  check_requests(asked, scene);
  effects.bounce_back = has_walls(scene);
  effects.closed_room = !has_open_sides(scene);
  effects.species_advection = !scene.species.empty();
  effects.transport_velocity = asked.value("thermal_noise") != true;
  for (const auto& [name, member] : of_flow) effects.*member = asked.value(name).value_or(effects.*member);
}

}  // namespace shmoo::scene
