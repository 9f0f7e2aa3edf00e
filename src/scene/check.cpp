#include "scene/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/nearest.hpp"

namespace shmoo::scene {
namespace {

constexpr std::size_t longest_name = 64;  // bytes that are compared with valid names

constexpr std::string_view no_space = "a well-mixed scene, one with [compartments], has no space; remove it";
constexpr std::string_view no_well =
    "only a well-mixed scene, one with [compartments] and no [domain], has it; remove it";

const Form* form_of(const std::vector<Form>& forms, std::initializer_list<Kind> kinds) {
  const auto found = std::find_if(forms.begin(), forms.end(), [&](const Form& form) {
    return std::find(kinds.begin(), kinds.end(), form.kind) != kinds.end();
  });
  return found == forms.end() ? nullptr : &*found;
}

// Of several forms with a unit the one that the text's unit speaks of, else the first.
const Form* quantity_form(const std::vector<Form>& forms, const std::string& text) {
  const Form* first = form_of(forms, {Kind::quantity, Kind::unit_later});
  if (!first || std::count_if(forms.begin(), forms.end(), [](const Form& f) { return f.kind == Kind::quantity; }) < 2)
    return first;
  try {
    const auto dimension = base::parse_quantity(text).dimension;
    for (const Form& form : forms)
      if (form.kind == Kind::quantity && form.dimension == dimension) return &form;
  } catch (const base::QuantityError&) {
  }
  return first;
}

bool belongs_to_a_shape(std::string_view name) {
  const auto named = [&](const Key& key) { return key.name == name; };
  return std::any_of(shape_tables().begin(), shape_tables().end(),
                     [&](const ShapeTable& shape) { return std::any_of(shape.keys.begin(), shape.keys.end(), named); });
}

std::vector<std::string> strings(const std::vector<std::string_view>& views) { return {views.begin(), views.end()}; }

}  // namespace

std::string join_path(const std::string& path, std::string_view key) {
  const bool plain = !key.empty() && key.find_first_of(". \"'\t\n") == std::string_view::npos;
  const std::string shown = plain && key.size() <= longest_name ? std::string(key) : quoted(key);
  return path.empty() ? shown : fmt::format("{}.{}", path, shown);
}

bool looks_like_quantity(std::string_view text) {
  auto rest = text.find_first_not_of(" \t+-");
  if (rest == std::string_view::npos || std::string_view("0123456789.").find(text[rest]) == std::string_view::npos)
    return false;
  rest = text.find_first_not_of("0123456789.eE", rest);
  if (rest != std::string_view::npos && (text[rest] == '-' || text[rest] == '+') &&
      (text[rest - 1] == 'e' || text[rest - 1] == 'E'))
    rest = text.find_first_not_of("0123456789", rest + 1);
  rest = rest == std::string_view::npos ? rest : text.find_first_not_of(" \t", rest);
  if (rest == std::string_view::npos) return false;
  return std::string_view("*+-/^?<>=!&|)").find(text[rest]) == std::string_view::npos;
}

std::string describe(const toml::node& value) {
  if (const auto* text = value.as_string()) return quoted(text->get());
  if (const auto* integer = value.as_integer()) return fmt::format("the number {}", integer->get());
  if (const auto* number = value.as_floating_point()) return fmt::format("the number {:#}", number->get());
  if (const auto* boolean = value.as_boolean()) return boolean->get() ? "true" : "false";
  if (value.is_array()) return "a list";
  if (value.is_table()) return "a table";
  return "a date or time";
}

std::vector<std::string> Checker::key_names(const Table& schema, const ShapeTable* shape) const {
  std::vector<std::string> names;
  const auto append = [&](const std::vector<Key>& keys) {
    for (const Key& key : keys)
      if (key.forms.front().kind != Kind::refused && known_here(key)) names.emplace_back(key.name);
  };
  append(schema.keys);
  if (schema.shape != ShapeUse::none && !well_) names.emplace_back(shape_key().name);
  if (shape) append(shape->keys);
  return names;
}

bool Checker::fail(const toml::node& value, const std::string& path, const std::string& message) {
  report_.add(value, fmt::format("{}: {}", path, message));
  return false;
}

bool Checker::wrong(const toml::node& value, const std::vector<Form>& forms, const std::string& path) {
  return fail(value, path, fmt::format("got {}; expected {}", describe(value), expected(forms, dimension_)));
}

void Checker::check_table(const toml::table& given, const Table& schema, const std::string& path) {
  if (schema.shape == ShapeUse::none) return check_keys(given, schema, nullptr, path);
  if (shape_depth_ >= deepest_shape) {
    report_.add(given,
                fmt::format("{}: shapes are nested too deep; at most {} levels are allowed", path, deepest_shape));
    return;
  }
  ++shape_depth_;
  check_keys(given, schema, shape_of(given, schema, path), path);
  --shape_depth_;
}

// The shape that the table says it is; null, with a message, where it names none.
const ShapeTable* Checker::shape_of(const toml::table& given, const Table& schema, const std::string& path) {
  const toml::node* name = given.get(shape_key().name);
  if (!name) {
    if (schema.shape == ShapeUse::required) check_required(given, shape_key(), path, {});
    return nullptr;
  }
  const auto* text = name->as_string();
  if (text && (text->get() == "stl" || text->get() == "gmsh")) {
    fail(*name, join_path(path, "shape"),
         "shapes from STL and Gmsh files are not in this version; compose the shape of others");
    return nullptr;
  }
  if (!check_value(*name, shape_key().forms, join_path(path, "shape"))) return nullptr;
  const ShapeTable* shape = find_shape(text->get());
  const auto& dimensions = shape->dimensions;
  if (dimension_ != 0 && std::find(dimensions.begin(), dimensions.end(), dimension_) == dimensions.end()) {
    fail(*name, join_path(path, "shape"),
         fmt::format("\"{}\" is a shape of two dimensions and the scene has {}; use \"ball\", \"shell\", "
                     "\"half_space\" or \"box\"",
                     shape->name, dimension_));
    return nullptr;
  }
  return shape;
}

void Checker::check_keys(const toml::table& given, const Table& schema, const ShapeTable* shape,
                         const std::string& path) {
  const toml::node* shape_node = schema.shape == ShapeUse::none ? nullptr : given.get(shape_key().name);
  std::vector<std::string> meant;  // names that unknown keys most likely stand for
  for (const auto& [key, value] : given) {
    const Key* known = find_key(schema, key.str(), shape);
    const bool misplaced = known && (!known_here(*known) || (well_ && known == &shape_key()));
    if (!known) known = find_key(schema, "NAME");
    const bool of_a_shape = !known && schema.shape != ShapeUse::none && !shape && belongs_to_a_shape(key.str());
    const bool nowhere = misplaced || (of_a_shape && well_);
    if (!nowhere && of_a_shape && (shape_node || schema.shape == ShapeUse::required))
      continue;  // the shape itself was reported
    if (nowhere)
      fail(value, join_path(path, key.str()), std::string(well_ ? no_space : no_well));
    else if (of_a_shape)
      fail(value, join_path(path, key.str()),
           "is a key of a shape, and there is no 'shape' beside it; add it, such as shape = \"box\"");
    else if (!known)
      unknown_key(key, value, schema, shape, path, meant);
    else if (known->forms.front().kind == Kind::refused)
      fail(value, join_path(path, key.str()), std::string(known->doc));
    else if (&value != shape_node)
      check_value(value, known->forms, join_path(path, key.str()));
  }
  for (const Key& key : schema.keys) check_required(given, key, path, meant);
  if (shape)
    for (const Key& key : shape->keys) check_required(given, key, path, meant);
}

void Checker::unknown_key(const toml::key& key, const toml::node& value, const Table& schema, const ShapeTable* shape,
                          const std::string& path, std::vector<std::string>& meant) {
  report_.mark_bad(value);
  const auto names = key_names(schema, shape);
  const std::string_view given = key.str().substr(0, longest_name);
  const std::string nearest = base::nearest_name(given, names);
  if (!nearest.empty()) meant.push_back(nearest);
  const bool needs_shape = schema.shape == ShapeUse::optional && !shape;
  const auto& at = value.source().path && value.source().path->starts_with("--set") ? value.source() : key.source();
  const auto rest = fmt::format("allowed here: {}{}", listed(names), needs_shape ? ", and the keys of a shape" : "");
  report_.add(at, fmt::format("{}: unknown key{}", join_path(path, key.str()), suggestion(given, names, rest)));
}

void Checker::check_required(const toml::table& given, const Key& key, const std::string& path,
                             const std::vector<std::string>& meant) {
  if (!key.required || !known_here(key) || given.contains(key.name)) return;
  if (std::find(meant.begin(), meant.end(), key.name) != meant.end()) return;
  report_.add(given.source(), fmt::format("{}: missing; expected {} ({})", join_path(path, key.name),
                                          expected(key.forms, dimension_), key.doc));
}

bool Checker::check_value(const toml::node& value, const std::vector<Form>& forms, const std::string& path) {
  if (const auto* text = value.as_string()) return check_string(value, text->get(), forms, path);
  if (value.is_integer() || value.is_floating_point()) return check_number(value, forms, path);
  if (value.is_boolean()) return form_of(forms, {Kind::boolean}) ? true : wrong(value, forms, path);
  if (value.is_array()) {
    const Form* form = form_of(forms, {Kind::list});
    return form ? check_list(value, *form, path) : wrong(value, forms, path);
  }
  if (const auto* inner = value.as_table()) {
    if (const Form* form = form_of(forms, {Kind::named})) return check_named(*inner, *form, path);
    const Form* form = form_of(forms, {Kind::table});
    if (!form) return wrong(value, forms, path);
    const auto before = report_.count();
    check_table(*inner, table(form->table), path);
    return report_.count() == before;
  }
  return wrong(value, forms, path);
}

bool Checker::check_string(const toml::node& value, const std::string& text, const std::vector<Form>& forms,
                           const std::string& path) {
  const Form* quantity = quantity_form(forms, text);
  const Form* words = form_of(forms, {Kind::text, Kind::expression});
  if (quantity && (!words || looks_like_quantity(text))) return check_quantity(value, text, *quantity, path);
  if (const Form* form = form_of(forms, {Kind::choice})) return check_choice(value, text, *form, forms, path);
  if (!words) return wrong(value, forms, path);
  return text.find_first_not_of(" \t\n\r") != std::string::npos || words->what == "any text" ||
                 words->kind == Kind::expression
             ? true
             : wrong(value, forms, path);
}

bool Checker::check_choice(const toml::node& value, const std::string& text, const Form& form,
                           const std::vector<Form>& forms, const std::string& path) {
  if (std::find(form.choices.begin(), form.choices.end(), text) != form.choices.end()) return true;
  return fail(value, path,
              fmt::format("got {}{}", quoted(text),
                          suggestion(text, strings(form.choices), fmt::format("expected {}", expected(forms)))));
}

bool Checker::check_quantity(const toml::node& value, const std::string& text, const Form& form,
                             const std::string& path) {
  const std::string wanted = form.kind == Kind::quantity ? base::expectation(form.dimension) : std::string(form.what);
  try {
    const base::Measured measured = base::parse_quantity(text);
    if (form.kind == Kind::quantity && measured.dimension != form.dimension)
      return fail(value, path,
                  fmt::format("{} is {}; expected {}", quoted(text), base::dimension_name(measured.dimension), wanted));
    if (form.range.holds(measured.value)) return true;
    return fail(value, path,
                fmt::format("{} is out of range; allowed is {}", quoted(text), allowed(form.range, form.dimension)));
  } catch (const base::QuantityError& error) {
    return fail(value, path, fmt::format("{}: {}; expected {}", quoted(text), error.what(), wanted));
  }
}

bool Checker::check_number(const toml::node& value, const std::vector<Form>& forms, const std::string& path) {
  const Form* form = form_of(forms, {Kind::integer, Kind::number});
  const double number = value.value_or(0.0);
  if (!form) {
    const Form* quantity = form_of(forms, {Kind::quantity, Kind::unit_later});
    if (!quantity) return wrong(value, forms, path);
    const std::string wanted =
        quantity->kind == Kind::quantity ? base::expectation(quantity->dimension) : std::string(quantity->what);
    return fail(value, path, fmt::format("got {} without a unit; expected {}", number, wanted));
  }
  if (form->kind == Kind::integer && !value.is_integer()) return wrong(value, forms, path);
  if (std::isfinite(number) && form->range.holds(number)) return true;
  if (!std::isfinite(number))
    return fail(value, path, fmt::format("{} is not finite; expected {}", number, expected(*form)));
  return fail(value, path, fmt::format("{} is out of range; allowed is {}", number, allowed(form->range, {})));
}

bool Checker::check_list(const toml::node& value, const Form& form, const std::string& path) {
  const toml::array& list = *value.as_array();
  const auto size = list.size();
  const bool per_axis = form.per_axis && dimension_ != 0;
  if ((per_axis && size != static_cast<std::size_t>(dimension_)) || size < form.least || size > form.most)
    return fail(value, path, fmt::format("got a list of {}; expected {}", size, expected(form, dimension_)));
  bool good = true;
  std::size_t index = 0;
  for (const toml::node& entry : list)
    good = check_value(entry, form.element, join_path(path, std::to_string(index++))) && good;
  if (!good) report_.mark_bad(value);
  return good;
}

bool Checker::check_named(const toml::table& given, const Form& form, const std::string& path) {
  bool good = true;
  for (const auto& [key, value] : given) good = check_value(value, form.element, join_path(path, key.str())) && good;
  return good;
}

}  // namespace shmoo::scene
