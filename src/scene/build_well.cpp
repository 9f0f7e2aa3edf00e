// Well-mixed scenes: compartments, and names that stand for formulas.
#include <fmt/format.h>

#include <algorithm>

#include "scene/build.hpp"
#include "scene/expression.hpp"

namespace shmoo::scene {
namespace {

constexpr std::size_t longest_definition = 100000;  // bytes, once written out

// The formula without definitions in it. `open`: definitions that are being written out.
const Formula& meaning_of(const std::string& name, const std::map<std::string, Formula>& written, Draft& draft,
                          std::vector<std::string>& open) {
  if (const auto known = draft.meaning.find(name); known != draft.meaning.end()) return known->second;
  if (std::find(open.begin(), open.end(), name) != open.end())
    throw ExpressionError(fmt::format("it is defined by itself: {} -> {}", listed(open), name));
  open.push_back(name);
  const Formula& formula = written.at(name);
  std::map<std::string, Formula> parts;
  for (const auto& [other, ignored] : written)
    if (reads(formula, other)) parts[other] = meaning_of(other, written, draft, open);
  open.pop_back();
  Formula whole = replace(formula, parts);
  if (write(whole).size() > longest_definition)
    throw ExpressionError(fmt::format("written out it has more than {} characters", longest_definition));
  return draft.meaning[name] = std::move(whole);
}

}  // namespace

void build_well(const Section& root, Draft& draft) {
  Material& all = draft.materials.emplace_back();
  all.name = "well";
  all.type = MaterialType::still;
  for (const auto& [name, section] : root.named_sections("compartments")) {
    if (!is_identifier(name))
      section.error(fmt::format("{} is no name of a compartment; use letters, digits and _", quoted(name)));
    draft.compartments.push_back({name, section.quantity("volume").value_or(1)});
  }
  if (const auto given = root.section("compartments"); given && given->table().empty())
    root.error("compartments", "there must be at least one [compartments.NAME] with a volume");
}

void build_definitions(const Section& root, Draft& draft) {
  const auto given = root.section("definitions");
  if (!given) return;
  std::map<std::string, Formula> written;
  for (const auto& [key, value] : given->table()) {
    const std::string name(key.str());
    if (given->report().bad(value)) continue;
    const auto same = [&](const Species& species) { return species.name == name; };
    const bool species = std::any_of(draft.species.begin(), draft.species.end(), same);
    if (const auto problem = identifier_problem(draft, name); !problem.empty()) given->error(name, problem);
    if (species || draft.parameters.contains(name) || draft.bad_names.contains(name))
      given->error(name,
                   fmt::format("a {} is called '{}' too; rename one of them", species ? "species" : "parameter", name));
    try {
      const auto number_given = value.value<double>();
      written[name] = number_given ? number(*number_given) : parse_formula(value.value_or(std::string()));
      if (!number_given) Expression(value.value_or(std::string()), {});  // for its messages
    } catch (const ExpressionError&) {
    }
  }
  std::vector<std::string> open;
  for (const auto& [name, formula] : written) {
    try {
      const Formula& whole = meaning_of(name, written, draft, open);
      draft.definitions.push_back({name, write(whole)});
    } catch (const ExpressionError& error) {
      open.clear();
      given->error(name, error.what());
    }
  }
  for (const auto& [name, formula] : written)
    if (given->find(name)->is_string() && draft.meaning.contains(name)) check_numbers(draft, *given, name, *given->find(name));
}

}  // namespace shmoo::scene
