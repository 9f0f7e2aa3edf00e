// Initial amounts.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/units.hpp"
#include "scene/build.hpp"

namespace shmoo::scene {
namespace {

constexpr double most_molecules = 9007199254740992.0;  // 2^53: beyond it counts are not exact

bool lives_in(const Species& species, int material) {
  return std::find(species.homes.begin(), species.homes.end(), material) != species.homes.end();
}

// A stochastic species holds whole molecules, counted exactly.
void check_molecules(const Scene& scene, const Section& section, std::string_view key, const toml::node& at,
                     const Species& species, double concentration) {
  double volume = scene.compartments.empty() || species.compartment >= int(scene.compartments.size())
                      ? scene.depth
                      : scene.compartments[static_cast<std::size_t>(species.compartment)].volume;
  for (int axis = 0; axis < scene.dimension; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    volume *= scene.domain.upper[a] - scene.domain.lower[a];
  }
  if (species.method == SpeciesMethod::stochastic && concentration * volume >= most_molecules)
    section.error(
        at, key,
        fmt::format("the domain would hold {:.3g} molecules of {}; a stochastic species has less than 2^53 = {:.3g}; "
                    "lower it, or use method = \"deterministic\"",
                    concentration * volume, species.name, most_molecules));
}

void check_whole(const Section& section, std::string_view key, const Species& species, double count) {
  if (species.method != SpeciesMethod::stochastic || count == std::round(count)) return;
  section.error(key, fmt::format("{:.17g} molecules are not whole, and {} is stochastic; give a whole number", count,
                                 species.name));
}

void read_initial_by_material(const Section& table, Draft& draft, int index) {
  if (draft.well)
    return table.error("a well-mixed scene has no materials; give one concentration or number of molecules");
  const Species& species = draft.species[static_cast<std::size_t>(index)];
  for (const auto& [key, value] : table.table()) {
    const int material = material_index(draft, std::string(key.str()), table, key.str(), value);
    if (material < 0) continue;
    if (!lives_in(species, material)) {
      table.error(key.str(),
                  fmt::format("{} does not live in {}; add it to 'in', or remove it here", species.name, key.str()));
      continue;
    }
    const auto amount = table.quantity(key.str());
    if (!amount) continue;
    check_molecules(draft, table, key.str(), value, species, *amount);
    draft.initials.push_back({index, material, nullptr, {*amount, ""}, std::nullopt});
  }
}

void read_species_initial(const Section& section, Draft& draft, int index) {
  const Species& species = draft.species[static_cast<std::size_t>(index)];
  if (const auto amount = section.quantity("initial")) {
    if (base::parse_quantity(*section.text("initial")).dimension == base::dimensions::amount) {
      if (!draft.well)
        section.error("initial",
                      "molecules in all belong in [[initial]], as its 'count'; expected a concentration here");
      check_whole(section, "initial", species, *amount);
      draft.initials.push_back({index, -1, nullptr, {}, *amount});
      return;
    }
    check_molecules(draft, section, "initial", *section.find("initial"), species, *amount);
    draft.initials.push_back({index, -1, nullptr, {*amount, ""}, std::nullopt});
    return;
  }
  const auto table = section.section("initial");
  if (!table) return;
  if (!table->has("expression")) return read_initial_by_material(*table, draft, index);
  for (const auto& [key, value] : table->table())
    if (key.str() != "expression")
      table->error(key.str(), "an expression stands alone; remove it, or give the amount by material only");
  const auto formula = table->text("expression");
  if (!formula) return;
  check_formula(draft, *table, "expression", *table->find("expression"), base::dimensions::concentration, Reads::place);
  draft.initials.push_back({index, -1, nullptr, {0, expanded(draft, *formula)}, std::nullopt});
}

// The one of concentration, count and expression that is given, as an Initial without species.
std::optional<Initial> read_amount(const Section& section, const Draft& draft) {
  int given = 0;
  for (const char* key : {"concentration", "count", "expression"}) given += section.has(key);
  if (given != 1) {
    section.error(given == 0 ? "missing amount; give one of 'concentration', 'count' and 'expression'"
                             : "give just one of 'concentration', 'count' and 'expression'");
    return std::nullopt;
  }
  Initial initial;
  initial.concentration.value = section.quantity("concentration").value_or(0);
  initial.count = section.quantity("count");
  if (const auto formula = section.text("expression")) {
    initial.concentration.expression = expanded(draft, *formula);
    check_formula(draft, section, "expression", *section.find("expression"), base::dimensions::concentration,
                  Reads::place);
  }
  return initial;
}

void add_initial(const Section& section, Draft& draft, const Initial& amount, const std::string& name,
                 const toml::node& at) {
  Initial initial = amount;
  initial.species = species_index(draft, name, section, "species", at);
  if (initial.species < 0) return;
  const Species& species = draft.species[static_cast<std::size_t>(initial.species)];
  if (initial.material >= 0 && !lives_in(species, initial.material))
    section.error("material", fmt::format("{} does not live there; add the material to species.{}.in", name, name));
  if (initial.count) check_whole(section, "count", species, *initial.count);
  if (const auto* node = section.find("concentration"))
    check_molecules(draft, section, "concentration", *node, species, initial.concentration.value);
  draft.initials.push_back(std::move(initial));
}

}  // namespace

void build_initials(const Section& root, Draft& draft) {
  std::size_t index = 0;
  for (const auto& named : root.named_sections("species"))
    read_species_initial(named.second, draft, static_cast<int>(index++));
  for (const auto& section : root.sections("initial")) {
    auto amount = read_amount(section, draft);
    const auto shape = section.has("shape") ? build_shape(section, draft.dimension) : nullptr;
    if (!amount || !section.has("species")) continue;
    amount->shape = shape;
    if (const auto name = section.text("material"))
      amount->material = material_index(draft, *name, section, "material", *section.find("material"));
    for (const auto& [name, node] : section.names("species")) add_initial(section, draft, *amount, name, *node);
  }
}

}  // namespace shmoo::scene
