// The schema's table as JSON Schema, draft 2020-12, so that editors complete and check model files.
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "scene/read.hpp"
#include "scene/schema.hpp"
#include "scene/study.hpp"

namespace shmoo::scene {
namespace {

using Json = nlohmann::ordered_json;

// A decimal number and a unit; units themselves are beyond a pattern.
constexpr auto quantity_pattern =
    R"(^[ \t]*[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?([ \t]*[^-+*/^0-9.,@ \t]|[ \t]+1[ \t]*/).*$)";
constexpr double exact_integers = 9007199254740992.0;  // 2^53: larger bounds are left to the program

Json any_of(const std::vector<Form>& forms);

void add_range(Json& json, const Range& range) {
  if (std::isfinite(range.lower)) json[range.open_lower ? "exclusiveMinimum" : "minimum"] = range.lower;
  if (std::isfinite(range.upper) && range.upper <= exact_integers)
    json[range.open_upper ? "exclusiveMaximum" : "maximum"] = range.upper;
}

Json list_json(const Form& form) {
  Json json{{"type", "array"}, {"items", any_of(form.element)}};
  if (form.per_axis) {
    json["minItems"] = 1;
    json["maxItems"] = 3;
    return json;
  }
  if (form.least > 0) json["minItems"] = form.least;
  if (form.most < std::numeric_limits<std::size_t>::max()) json["maxItems"] = form.most;
  return json;
}

Json form_json(const Form& form) {
  Json json;
  switch (form.kind) {
    case Kind::boolean:
      return {{"type", "boolean"}};
    case Kind::integer:
      json = {{"type", "integer"}};
      break;
    case Kind::number:
      json = {{"type", "number"}};
      break;
    case Kind::text:
    case Kind::expression:
      return {{"type", "string"}};
    case Kind::choice:
      return {{"enum", form.choices}};
    case Kind::quantity:
    case Kind::unit_later:
      return {{"type", "string"}, {"pattern", quantity_pattern}};
    case Kind::list:
      return list_json(form);
    case Kind::table:
      return {{"$ref", "#/$defs/" + std::string(form.table)}};
    case Kind::named:
      return {{"type", "object"}, {"additionalProperties", any_of(form.element)}};
    case Kind::refused:
      return false;
  }
  add_range(json, form.range);
  return json;
}

Json any_of(const std::vector<Form>& forms) {
  if (forms.size() == 1) return form_json(forms.front());
  Json all = Json::array();
  for (const Form& form : forms) all.push_back(form_json(form));
  return {{"anyOf", all}};
}

Json key_json(const Key& key) {
  Json json = any_of(key.forms);
  if (json.is_boolean()) return json;
  std::string description(key.doc);
  description += ": " + expected(key.forms);
  if (!key.fallback.empty()) description += "; default: " + std::string(key.fallback);
  json["description"] = description;
  return json;
}

Json required_of(const std::vector<Key>& keys, Place elsewhere = Place::well) {
  Json required = Json::array();
  for (const Key& key : keys)
    if (key.required && key.place != elsewhere) required.push_back(key.name);
  return required;
}

// A file has the keys of space, or those of a well; an SBML network says all that is required.
void choose_place(Json& json, const std::vector<Key>& keys) {
  json["required"] = Json::array();
  const auto add = [&](Place elsewhere, const Json& required) {
    Json one{{"required", required}, {"properties", Json::object()}};
    for (const Key& key : keys)
      if (key.place == elsewhere) one["properties"][std::string(key.name)] = false;
    json["anyOf"].push_back(std::move(one));
  };
  add(Place::well, required_of(keys, Place::well));
  add(Place::space, required_of(keys, Place::space));
  add(Place::space, Json{"network"});
}

// Keys that go with a shape: all of them as properties; which of them is said by one if-then for each shape.
void add_shapes(Json& json, ShapeUse use) {
  Json& properties = json["properties"];
  properties["shape"] = key_json(shape_key());
  if (use == ShapeUse::required) json["required"].push_back("shape");
  std::map<std::string, Json> alternatives;
  for (const ShapeTable& shape : shape_tables())
    for (const Key& key : shape.keys) {
      Json& known = alternatives.try_emplace(std::string(key.name), Json::array()).first->second;
      const Json one = key_json(key);
      if (std::find(known.begin(), known.end(), one) == known.end()) known.push_back(one);
    }
  for (const auto& [name, forms] : alternatives) {
    properties[name] = forms.size() == 1 ? forms.front() : Json{{"anyOf", forms}};
    json["dependentRequired"][name] = {"shape"};
  }
  for (const ShapeTable& shape : shape_tables()) {
    Json then{{"properties", Json::object()}, {"required", required_of(shape.keys)}};
    for (const auto& [name, forms] : alternatives) then["properties"][name] = false;
    for (const Key& key : shape.keys) then["properties"][std::string(key.name)] = any_of(key.forms);
    const Json condition{{"properties", {{"shape", {{"const", shape.name}}}}}, {"required", {"shape"}}};
    json["allOf"].push_back({{"if", condition}, {"then", then}});
  }
}

Json table_json(const Table& table) {
  Json json{{"type", "object"},
            {"description", table.doc},
            {"properties", Json::object()},
            {"required", required_of(table.keys)}};
  json["additionalProperties"] = false;
  for (const Key& key : table.keys) {
    if (key.name == "NAME")
      json["additionalProperties"] = key_json(key);
    else if (key.forms.front().kind != Kind::refused)
      json["properties"][std::string(key.name)] = key_json(key);
  }
  if (table.shape != ShapeUse::none) add_shapes(json, table.shape);
  if (table.id.empty()) choose_place(json, table.keys);
  return json;
}

}  // namespace

namespace {

// The first table is the file itself.
std::string schema_of(const char* title, const std::vector<Table>& all) {
  Json json{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  json.update(table_json(all.front()));
  for (std::size_t t = 1; t < all.size(); ++t) json["$defs"][std::string(all[t].id)] = table_json(all[t]);
  return json.dump(2) + "\n";
}

}  // namespace

std::string json_schema() { return schema_of("Shmoo model file", tables()); }

std::string study_json_schema() {
  auto all = study_tables();
  all.push_back(table("part"));
  return schema_of("Shmoo study file", all);
}

}  // namespace shmoo::scene
