// Formulas in the light of the scene: the names that they may use and the dimensions of these.
#include <algorithm>
#include <array>

#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/expression.hpp"

namespace shmoo::scene {
namespace {

struct Names {
  std::vector<Variable> variables;
  std::size_t first_species = 0;
};

// Concentrations are tried over all that occurs, from a molecule in a cubic millimetre to water.
Names names_of(const Draft& draft, Reads reads) {
  Names names;
  const auto axis = [&](std::size_t i) {
    names.variables.push_back(
        {std::string(1, axis_names[i]), base::dimensions::length, draft.domain.lower[i], draft.domain.upper[i]});
  };
  for (std::size_t i = 0; i < 3 && !draft.well; ++i) axis(i);
  for (const auto& [name, value] : draft.parameters) {
    const auto dimension = draft.parameter_dimensions.find(name);
    names.variables.push_back(
        {name, dimension == draft.parameter_dimensions.end() ? base::Dimension{} : dimension->second, value, value});
  }
  for (const auto& name : draft.bad_names) names.variables.push_back({name, {}});
  if (reads != Reads::place)
    names.variables.push_back({"t", base::dimensions::time, 0, std::max(draft.run.until, 1e-300)});
  names.first_species = names.variables.size();
  if (reads == Reads::rate_law)
    for (const auto& species : draft.species)
      if (is_identifier(species.name) && !draft.parameters.contains(species.name) &&
          !draft.bad_names.contains(species.name))
        names.variables.push_back({species.name, base::dimensions::concentration, 1e9, 1e29, true});
  return names;
}

}  // namespace

std::vector<int> check_formula(const Draft& draft, const Section& section, std::string_view key, const toml::node& at,
                               const base::Dimension& dimension, Reads reads) {
  const auto [variables, first_species] = names_of(draft, reads);
  std::vector<std::string> names;
  for (const auto& variable : variables) names.push_back(variable.name);
  std::vector<int> used;
  try {
    const Expression expression(expanded(draft, at.value_or(std::string())), names);
    bool sound = true;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      if (!expression.uses(i)) continue;
      if (draft.bad_names.contains(names[i])) sound = false;
      if (i < first_species) continue;
      const auto species = std::find_if(draft.species.begin(), draft.species.end(),
                                        [&](const Species& one) { return one.name == names[i]; });
      used.push_back(static_cast<int>(species - draft.species.begin()));
    }
    if (!sound) return used;
    check_dimension(expression, variables, dimension);
    if (dimension == base::dimensions::concentration) check_not_negative(expression, variables);
  } catch (const ExpressionError& error) {
    section.error(at, key, error.what());
  }
  return used;
}

std::vector<int> check_numbers(const Draft& draft, const Section& section, std::string_view key, const toml::node& at) {
  const auto [variables, first_species] = names_of(draft, Reads::rate_law);
  std::vector<std::string> names;
  for (const auto& variable : variables) names.push_back(variable.name);
  std::vector<int> used;
  try {
    const Expression expression(expanded(draft, at.value_or(std::string())), names);
    for (std::size_t s = 0; s < draft.species.size(); ++s) {
      const auto place =
          std::find(names.begin() + static_cast<long>(first_species), names.end(), draft.species[s].name);
      if (place != names.end() && expression.uses(static_cast<std::size_t>(place - names.begin())))
        used.push_back(static_cast<int>(s));
    }
  } catch (const ExpressionError& error) {
    section.error(at, key, error.what());
  }
  return used;
}

std::string expanded(const Draft& draft, const std::string& text) {
  if (draft.meaning.empty()) return text;
  try {
    return write(replace(parse_formula(text), draft.meaning));
  } catch (const ExpressionError&) {
    return text;
  }
}

}  // namespace shmoo::scene
