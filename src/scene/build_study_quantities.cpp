// What a study measures, and against what.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>

#include "base/exact_solutions.hpp"
#include "scene/build.hpp"
#include "scene/motion.hpp"
#include "scene/study_parts.hpp"

namespace shmoo::scene {
namespace {

std::optional<StudyNumber> number_of(const Section& section, std::string_view key) {
  const auto* node = section.good(key);
  if (!node) return std::nullopt;
  StudyNumber number{.where = section.report().location(node->source())};
  if (const auto* text = node->as_string()) {
    try {
      const auto measured = base::parse_quantity(text->get());
      number.value = measured.value;
      number.dimension = measured.dimension;
    } catch (const base::QuantityError&) {
      number.path = text->get();
    }
  } else {
    number.value = node->value_or(0.0);
  }
  return number;
}

std::vector<std::string> formula_names() {
  std::vector<std::string> names;
  for (const auto& one : base::exact_solutions()) names.emplace_back(one.name);
  return names;
}

void read_parameters(const Section& section, const base::ExactSolution& solution, StudyReference& reference) {
  const auto given = section.section("parameters");
  std::vector<std::string> names;
  for (const auto& parameter : solution.parameters) names.emplace_back(parameter.name);
  if (given)
    for (const auto& [key, value] : given->table())
      if (std::find(names.begin(), names.end(), key.str()) == names.end())
        given->error(key.str(),
                     fmt::format("{} has no such parameter{}", solution.name,
                                 suggestion(key.str(), names, fmt::format("parameters: {}", listed(names)))));
  for (const auto& parameter : solution.parameters) {
    const auto number = given ? number_of(*given, parameter.name) : std::nullopt;
    if (!number && (!given || !given->has(parameter.name)))
      section.error("parameters", fmt::format("{} is missing; {} needs {}", parameter.name, solution.name,
                                              base::expectation(parameter.dimension)));
    if (number && number->path.empty() && number->dimension != parameter.dimension)
      given->error(parameter.name, fmt::format("expected {}, or the path of such a key of the model",
                                               base::expectation(parameter.dimension)));
    reference.parameters.push_back(number.value_or(StudyNumber{}));
    reference.parameters.back().dimension = parameter.dimension;
  }
}

void read_formula(const Section& section, StudyReference& reference) {
  reference.type = StudyReference::Type::formula;
  reference.formula = *section.text("formula");
  const auto* solution = base::find_exact_solution(reference.formula);
  if (solution) return read_parameters(section, *solution, reference);
  const auto names = formula_names();
  section.error("formula", fmt::format("there is no exact solution {}{}", scene::quoted(reference.formula),
                                       suggestion(reference.formula, names, fmt::format("known: {}", listed(names)))));
}

void read_tables(const Section& section, const Study& study, StudyReference& reference) {
  reference.type = StudyReference::Type::table;
  reference.column = section.text("column").value_or("");
  const auto folder = std::filesystem::path(study.file).parent_path();
  for (const auto& [name, node] : section.names("table")) {
    const auto path = (folder / name).lexically_normal();
    if (!std::filesystem::is_regular_file(path))
      section.error(*node, "table", fmt::format("there is no file {} beside the study", scene::quoted(name)));
    reference.tables.push_back(path.string());
  }
  if (reference.tables.size() > 1 && reference.tables.size() != study.levels.size())
    section.error("table", fmt::format("{} tables for {} levels; give one, or one per level", reference.tables.size(),
                                       study.levels.size()));
}

StudyReference reference_of(const Section& section, const Study& study) {
  StudyReference reference;
  reference.value = number_of(section, "value");
  const bool finest = section.boolean("finest").value_or(false);
  const int given = int(section.has("formula")) + int(section.has("table")) + int(finest && !section.has("method")) +
                    int(section.has("method")) + int(section.has("value") && !section.has("table"));
  if (given != 1)
    section.error(fmt::format("{} of 'formula', 'table', 'finest', 'method' and 'value' are given; give one", given));
  if (section.text("formula"))
    read_formula(section, reference);
  else if (section.has("table"))
    read_tables(section, study, reference);
  else if (finest || section.has("method")) {
    reference.type = StudyReference::Type::method;
    if (section.has("method")) reference.method = method_index(section, "method", study);
    reference.finest = finest;
  }
  if (section.has("parameters") && !section.has("formula"))
    section.error("parameters", "only a formula has them; remove it");
  if (section.has("column") && !section.has("table")) section.error("column", "only a table has it; remove it");
  return reference;
}

std::vector<std::string> field_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& species : scene.species) names.push_back(species.name);
  if (in_motion(scene)) names.insert(names.end(), {"velocity", "density", "pressure"});
  if (quasi_static(scene)) names.insert(names.end(), {"hoop_strain", "hoop_stress"});
  return names;
}

std::vector<std::string> observable_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const auto& observable : scene.observables) names.push_back(observable.name);
  return names;
}

std::string known_name(const Section& section, std::string_view key, const std::vector<std::string>& names) {
  const auto name = section.text(key);
  if (!name) return "";
  if (std::find(names.begin(), names.end(), *name) == names.end())
    section.error(key, fmt::format("the model has no {} {}{}", key, scene::quoted(*name),
                                   suggestion(*name, names, fmt::format("it has: {}", listed(names)))));
  return *name;
}

StudyNorm norm_of(const Section& section, std::string_view key, StudyNorm fallback) {
  const auto text = section.text(key);
  if (text == "rms") return StudyNorm::rms;
  if (text == "maximum") return StudyNorm::maximum;
  if (text == "root_sum_over_n") return StudyNorm::root_sum_over_n;
  return fallback;
}

void read_times(const Section& section, StudyQuantity& quantity) {
  if (const auto* node = section.good("time"))
    quantity.times = node->is_array() ? quantities_of(*node) : std::vector<double>{quantity_of(*node)};
  const std::array<std::pair<const char*, std::optional<std::array<double, 2>>*>, 5> windows{
      {{"average", &quantity.average},
       {"amplitude", &quantity.amplitude},
       {"period", &quantity.period},
       {"harmonic", &quantity.harmonic},
       {"harmonic_period", &quantity.harmonic_period}}};
  const char* given = nullptr;
  for (const auto& [key, member] : windows) {
    const auto window = section.quantities(key);
    if (window.size() != 2) continue;
    *member = {window[0], window[1]};
    if (given) section.error(key, fmt::format("and '{}' are both given; give one", given));
    given = key;
    if (section.has("time")) section.error(key, "and 'time' are both given; give one");
    if (section.has("field"))
      section.error(key, "is taken of an observable only");
    else if (window[0] >= window[1])
      section.error(key, "the second time must be later than the first");
  }
}

void read_published(const Section& section, const Study& study, StudyQuantity& quantity) {
  const auto table = section.section("published");
  if (!table) return;
  for (const auto& [key, value] : table->table()) {
    const auto name = std::string(key.str());
    const bool known = std::any_of(study.methods.begin(), study.methods.end(), [&](auto& m) { return m.name == name; });
    if (!known) table->error(key.str(), "there is no such method");
    if (section.report().bad(value)) continue;
    quantity.published[name] = quantities_of(value);
    if (quantity.published[name].size() != study.levels.size())
      table->error(key.str(), fmt::format("{} figures for {} levels; give one per level, 0 where there is none",
                                          quantity.published[name].size(), study.levels.size()));
  }
}

StudyQuantity quantity_in(const Section& section, const Scene& scene, const Study& study) {
  StudyQuantity quantity;
  quantity.name = section.text("name").value_or("");
  quantity.field = known_name(section, "field", field_names(scene));
  quantity.observable = known_name(section, "observable", observable_names(scene));
  if (section.has("field") == section.has("observable"))
    section.error(section.has("field") ? "field" : "observable", section.has("field")
                                                                     ? "and 'observable' are both given; give one"
                                                                     : "missing; give 'field' or 'observable'");
  for (const auto& observable : scene.observables)
    if (observable.name == quantity.observable) quantity.axis = static_cast<std::size_t>(observable.axis);
  quantity.component = axis_names.find(section.text("component").value_or("x"));
  if (section.has("shape")) quantity.region = build_shape(section, scene.dimension);
  read_times(section, quantity);
  if (const auto reference = section.section("reference")) quantity.reference = reference_of(*reference, study);
  quantity.norm = norm_of(section, "norm", StudyNorm::rms);
  quantity.published_norm = norm_of(section, "published_norm", quantity.norm);
  quantity.scale = number_of(section, "scale");
  quantity.relative = section.boolean("relative").value_or(false);
  if (quantity.relative && quantity.scale) section.error("scale", "and 'relative' are both given; give one");
  read_published(section, study, quantity);
  return quantity;
}

}  // namespace

void build_quantities(const Section& root, const Scene& scene, Study& study) {
  std::set<std::string> taken;
  for (const auto& section : root.sections("quantity")) {
    study.quantities.push_back(quantity_in(section, scene, study));
    const auto& name = study.quantities.back().name;
    if (!name.empty() && !taken.insert(name).second)
      section.error("name", fmt::format("{} is there twice; names must differ", scene::quoted(name)));
  }
}

}  // namespace shmoo::scene
