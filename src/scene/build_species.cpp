// Parameters and species.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/expression.hpp"

namespace shmoo::scene {
namespace {

constexpr std::size_t most_names = 10000;  // species or parameters
constexpr std::size_t longest_name = 64;   // bytes
constexpr std::array axes{"x", "y", "z"};  // of scenes that have places

void read_compartment(const Section& section, const Scene& scene, Species& species) {
  species.homes = {0};
  std::vector<std::string> names;
  for (const Compartment& one : scene.compartments) names.push_back(one.name);
  if (!section.has("in")) {
    species.compartment = 0;
    if (names.size() > 1)
      section.error(
          "in", fmt::format("missing; there are several compartments ({}), so say in which it lives", listed(names)));
    return;
  }
  const auto given = section.names("in");
  if (given.size() > 1) return section.error("in", "a species of a well-mixed scene lives in just one compartment");
  if (given.empty()) return;
  const auto found = std::find(names.begin(), names.end(), given.front().first);
  species.compartment = static_cast<int>(found - names.begin());
  if (found == names.end())
    section.error("in",
                  fmt::format("no compartment is called {}{}", quoted(given.front().first),
                              suggestion(given.front().first, names, fmt::format("compartments: {}", listed(names)))));
}

void read_homes(const Section& section, const Draft& scene, Species& species) {
  if (scene.well) return read_compartment(section, scene, species);
  if (section.has("in")) {
    bool good = true;
    species.homes = material_list(scene, section, "in", good);
    return;
  }
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (scene.materials[i].type != MaterialType::wall) species.homes.push_back(static_cast<int>(i));
  if (species.homes.empty() && !scene.materials.empty())
    section.error("in", "missing; all materials are walls, so say in which of them the species lives");
}

void limit_names(const Section& root, std::string_view key) {
  const auto given = root.section(key);
  if (given && given->table().size() > most_names)
    root.error(key, fmt::format("there are {}; at most {} are allowed", given->table().size(), most_names));
}

}  // namespace

std::string identifier_problem(const Draft& draft, const std::string& name) {
  if (!is_identifier(name) || name.size() > longest_name)
    return fmt::format("{} is no name for expressions; use up to {} letters, digits and _, not beginning with a digit",
                       quoted(name), longest_name);
  const auto& reserved = reserved_names();
  const bool axis = !draft.well && std::find(axes.begin(), axes.end(), name) != axes.end();
  if (axis || name == "t" || std::find(reserved.begin(), reserved.end(), name) != reserved.end())
    return fmt::format("'{}' has a meaning of its own in expressions; choose another name", name);
  if (name == "nothing") return "'nothing' stands for no species in equations; choose another name";
  return "";
}

void build_parameters(const Section& root, Draft& draft) {
  limit_names(root, "parameters");
  const auto given = root.section("parameters");
  if (!given) return;
  for (const auto& [key, value] : given->table()) {
    const std::string name(key.str());
    if (const auto problem = identifier_problem(draft, name); !problem.empty()) {
      given->error(name, problem);
    } else if (given->report().bad(value)) {
      draft.bad_names.insert(name);
    } else {
      draft.parameters[name] = quantity_of(value);
      const auto text = given->text(name);
      if (value.is_string()) draft.parameter_dimensions[name] = base::parse_quantity(*text).dimension;
    }
  }
}

void build_species(const Section& root, Draft& draft) {
  limit_names(root, "species");
  for (const auto& [name, section] : root.named_sections("species")) {
    Species species;
    species.name = name;
    species.where = section.where();
    if (const auto problem = identifier_problem(draft, name); !problem.empty()) section.error(problem);
    if (draft.parameters.contains(name) || draft.bad_names.contains(name))
      section.error(fmt::format("a parameter is called '{}' too; rename one of them", name));
    species.diffusivity = section.quantity("diffusivity").value_or(0);
    species.method = draft.numerics.method;
    read_choice(section, "method", species_methods, species.method);
    read_homes(section, draft, species);
    draft.species.push_back(std::move(species));
  }
}

int species_index(const Scene& scene, const std::string& name, const Section& section, std::string_view key,
                  const toml::node& at) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.species.size(); ++i) {
    if (scene.species[i].name == name) return static_cast<int>(i);
    names.push_back(scene.species[i].name);
  }
  section.error(at, key,
                fmt::format("no species is called {}{}", quoted(name),
                            suggestion(name, names, fmt::format("species: {}", listed(names)))));
  return -1;
}

}  // namespace shmoo::scene
