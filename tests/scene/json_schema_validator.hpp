#pragma once
// The part of JSON Schema, draft 2020-12, that the model file's schema uses. Any other keyword is a failure.
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

namespace shmoo::scene {

class JsonSchemaValidator {
 public:
  explicit JsonSchemaValidator(nlohmann::json schema) : schema_(std::move(schema)) {}

  bool valid(const nlohmann::json& value) const { return holds(schema_, value); }

 private:
  using Json = nlohmann::json;

  bool holds(const Json& schema, const Json& value) const {
    if (schema.is_boolean()) return schema.get<bool>();
    for (const auto& [keyword, rule] : schema.items())
      if (!holds(schema, keyword, rule, value)) return false;
    return true;
  }

  bool holds(const Json& schema, const std::string& keyword, const Json& rule, const Json& value) const {
    static const std::set<std::string> silent{"$schema", "title", "description", "$defs", "then"};
    if (silent.contains(keyword)) return true;
    if (keyword == "$ref") return holds(schema_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value);
    if (keyword == "anyOf")
      return std::any_of(rule.begin(), rule.end(), [&](const Json& one) { return holds(one, value); });
    if (keyword == "allOf")
      return std::all_of(rule.begin(), rule.end(), [&](const Json& one) { return holds(one, value); });
    if (keyword == "if") return !holds(rule, value) || holds(schema.at("then"), value);
    if (keyword == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    if (keyword == "const") return rule == value;
    if (keyword == "type") return of_type(rule.get<std::string>(), value);
    if (keyword == "pattern")
      return !value.is_string() || std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>()));
    if (keyword.ends_with("inimum") || keyword.ends_with("aximum")) return in_range(keyword, rule, value);
    if (keyword == "items" || keyword == "minItems" || keyword == "maxItems") return list_holds(keyword, rule, value);
    return object_holds(schema, keyword, rule, value);
  }

  static bool of_type(const std::string& type, const Json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    throw std::logic_error("unknown type " + type);
  }

  static bool in_range(const std::string& keyword, const Json& rule, const Json& value) {
    if (!value.is_number()) return true;
    const double bound = rule.get<double>(), number = value.get<double>();
    if (keyword == "minimum") return number >= bound;
    if (keyword == "maximum") return number <= bound;
    if (keyword == "exclusiveMinimum") return number > bound;
    return number < bound;
  }

  bool list_holds(const std::string& keyword, const Json& rule, const Json& value) const {
    if (!value.is_array()) return true;
    if (keyword == "minItems") return value.size() >= rule.get<std::size_t>();
    if (keyword == "maxItems") return value.size() <= rule.get<std::size_t>();
    return std::all_of(value.begin(), value.end(), [&](const Json& one) { return holds(rule, one); });
  }

  bool object_holds(const Json& schema, const std::string& keyword, const Json& rule, const Json& value) const {
    if (!value.is_object()) return true;
    for (const auto& [key, inner] : value.items()) {
      const bool named = schema.contains("properties") && schema.at("properties").contains(key);
      if (keyword == "properties" && named && !holds(rule.at(key), inner)) return false;
      if (keyword == "additionalProperties" && !named && !holds(rule, inner)) return false;
    }
    if (keyword == "properties" || keyword == "additionalProperties") return true;
    if (keyword == "required")
      return std::all_of(rule.begin(), rule.end(),
                         [&](const Json& key) { return value.contains(key.get<std::string>()); });
    if (keyword != "dependentRequired") throw std::logic_error("unknown keyword " + keyword);
    for (const auto& [key, others] : rule.items())
      if (value.contains(key))
        for (const auto& other : others)
          if (!value.contains(other.get<std::string>())) return false;
    return true;
  }

  Json schema_;
};

}  // namespace shmoo::scene
