#include "scene/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "scene/tables.hpp"

namespace shmoo::scene {

const std::vector<Table>& tables() {
  static const std::vector<Table> all = [] {
    std::vector<Table> joined;
    for (const auto& part :
         {world_tables(), refinement_tables(), chemistry_tables(), flow_tables(), mechanics_tables(), run_tables()})
      joined.insert(joined.end(), part.begin(), part.end());
    return joined;
  }();
  return all;
}

const std::vector<Table>& study_tables() {
  static const std::vector<Table> all = study_file_tables();
  return all;
}

const Table& table(std::string_view id) {
  for (const auto* part : {&tables(), &study_tables()})
    for (const Table& one : *part)
      if (one.id == id) return one;
  throw std::logic_error(fmt::format("the schema has no table '{}'", id));
}

const ShapeTable* find_shape(std::string_view name) {
  const auto& shapes = shape_tables();
  const auto found =
      std::find_if(shapes.begin(), shapes.end(), [&](const ShapeTable& one) { return one.name == name; });
  return found == shapes.end() ? nullptr : &*found;
}

const Key* find_key(const Table& table, std::string_view name, const ShapeTable* shape) {
  const auto named = [&](const Key& key) { return key.name == name; };
  if (const auto key = std::find_if(table.keys.begin(), table.keys.end(), named); key != table.keys.end()) return &*key;
  if (table.shape == ShapeUse::none) return nullptr;
  if (name == shape_key().name) return &shape_key();
  if (!shape) return nullptr;
  const auto key = std::find_if(shape->keys.begin(), shape->keys.end(), named);
  return key == shape->keys.end() ? nullptr : &*key;
}

std::string allowed(const Range& range, const base::Dimension& dimension) {
  const std::string unit = dimension == base::dimensions::none ? "" : fmt::format(" {}", base::si_unit(dimension));
  const bool below = range.lower > -std::numeric_limits<double>::infinity();
  const bool above = range.upper < std::numeric_limits<double>::infinity();
  const char* const lower_sign = range.open_lower ? ">" : ">=";
  const char* const upper_sign = range.open_upper ? "<" : "<=";
  if (below && above) return fmt::format("{} {} and {} {}{}", lower_sign, range.lower, upper_sign, range.upper, unit);
  if (below) return fmt::format("{} {}{}", lower_sign, range.lower, unit);
  if (above) return fmt::format("{} {}{}", upper_sign, range.upper, unit);
  return "any";
}

namespace {

std::string expected_list(const Form& form, int dimension) {
  std::string count;
  if (form.per_axis)
    count = dimension == 0 ? "with one entry per axis" : fmt::format("of {}", dimension);
  else if (form.least == form.most)
    count = fmt::format("of {}", form.least);
  else if (form.least > 0)
    count = fmt::format("of at least {}", form.least);
  const std::string entries = expected(form.element, dimension);
  return count.empty() ? fmt::format("a list (each entry {})", entries)
                       : fmt::format("a list {} (each entry {})", count, entries);
}

std::string with_range(std::string text, const Form& form) {
  return form.range.limited() ? fmt::format("{} ({})", text, allowed(form.range, form.dimension)) : text;
}

}  // namespace

std::string expected(const Form& form, int dimension) {
  switch (form.kind) {
    case Kind::boolean:
      return "true or false";
    case Kind::integer:
      return with_range("a whole number", form);
    case Kind::number:
      return with_range("a number", form);
    case Kind::text:
    case Kind::unit_later:
      return std::string(form.what);
    case Kind::expression:
      return fmt::format("{} in quotes", form.what);
    case Kind::choice:
      return fmt::format("{}\"{}\"", form.choices.size() > 1 ? "one of " : "", fmt::join(form.choices, "\", \""));
    case Kind::quantity:
      return base::expectation(form.dimension);
    case Kind::list:
      return expected_list(form, dimension);
    case Kind::table:
      return "a table";
    case Kind::named:
      return fmt::format("a table whose keys are each {}", form.what);
    case Kind::refused:
      return "nothing";
  }
  return "";
}

std::string expected(const std::vector<Form>& forms, int dimension) {
  std::vector<std::string> each;
  for (const Form& form : forms) each.push_back(expected(form, dimension));
  return fmt::format("{}", fmt::join(each, ", or "));
}

}  // namespace shmoo::scene
