// Elastic solids: what their materials have besides type, density and the motion of what is held.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {
namespace {

void refuse_keys_of_solids(const Section& section) {
  for (const Key& key : solid_keys())
    if (section.has(key.name)) section.error(key.name, "only a solid has it; remove it");
}

void read_moduli(const Section& section, Elastic& elastic) {
  elastic.poisson_ratio = section.number("poisson_ratio").value_or(0);
  const bool young = section.has("young_modulus"), shear = section.has("shear_modulus");
  if (young && shear) section.error("shear_modulus", "give either 'young_modulus' or 'shear_modulus', not both");
  if (!young && !shear) section.error("young_modulus", "missing; a solid has 'young_modulus' or 'shear_modulus'");
  for (const char* key : {"density", "poisson_ratio"})
    if (!section.has(key)) section.error(key, "missing; a solid has one");
  elastic.shear_modulus = shear ? section.quantity("shear_modulus").value_or(0)
                                : section.quantity("young_modulus").value_or(0) / (2 * (1 + elastic.poisson_ratio));
}

// Formulas of a velocity are those of the fluid's.
void read_initial_velocity(const Section& section, const Draft& draft, Elastic& elastic) {
  const auto* list = section.good("initial_velocity");
  if (list && list->is_array()) elastic.initial_velocity = velocity_formulas(draft, section, "initial_velocity", *list);
}

std::optional<Softening> read_softening(const Section& section, const Draft& draft, const Material& material) {
  const auto table = section.section("softening");
  if (!table) return std::nullopt;
  Softening softening;
  softening.coefficient = table->quantity("coefficient").value_or(0);
  softening.least = table->number("least").value_or(softening.least);
  const auto name = table->text("species");
  softening.species = name ? species_index(draft, *name, *table, "species", *table->find("species")) : -1;
  if (softening.species < 0) return std::nullopt;
  const auto& homes = draft.species[std::size_t(softening.species)].homes;
  const auto lives = [&](int home) { return draft.materials[std::size_t(home)].name == material.name; };
  if (std::none_of(homes.begin(), homes.end(), lives))
    table->error("species",
                 fmt::format("{} does not live in {}; add it to species.{}.in", *name, material.name, *name));
  return softening;
}

Elastic elastic_of(const Section& section, const Draft& draft, const Material& material) {
  Elastic elastic;
  read_choice(
      section, "law",
      std::array<std::pair<const char*, ElasticLaw>, 3>{{{"neo-hookean", ElasticLaw::neo_hookean},
                                                         {"saint-venant-kirchhoff", ElasticLaw::saint_venant_kirchhoff},
                                                         {"hooke-jaumann", ElasticLaw::hooke_jaumann}}},
      elastic.law);
  read_moduli(section, elastic);
  if (const auto fixed = section.section("fixed")) elastic.fixed = build_shape(*fixed, draft.dimension);
  if (material.motion && !section.has("fixed"))
    section.error("fixed",
                  "missing; a velocity moves the held part of a solid, so give its shape; what a free solid "
                  "starts with is 'initial_velocity'");
  read_initial_velocity(section, draft, elastic);
  elastic.softening = read_softening(section, draft, material);
  elastic.body_force = section.point("body_force").value_or(Point{});
  for (const char* key : {"artificial_stress", "artificial_viscosity"})
    if (section.has(key) && elastic.law != ElasticLaw::hooke_jaumann)
      section.error(key, "only the law \"hooke-jaumann\" has it; remove it");
  elastic.artificial_stress = section.number("artificial_stress").value_or(elastic.artificial_stress);
  elastic.artificial_viscosity = section.number("artificial_viscosity").value_or(1.0);
  return elastic;
}

}  // namespace

void build_solids(const Section& root, Draft& draft) {
  for (const auto& [name, section] : root.named_sections("materials")) {
    for (Material& material : draft.materials) {
      if (material.name != name) continue;
      if (material.type == MaterialType::solid)
        material.elastic = elastic_of(section, draft, material);
      else if (section.good("type"))
        refuse_keys_of_solids(section);
    }
  }
  if (draft.dimension == 1)
    for (const Material& material : draft.materials)
      if (material.type == MaterialType::solid)
        root.error("dimension", fmt::format("the solid {} needs 2 or 3 dimensions", material.name));
}

}  // namespace shmoo::scene
