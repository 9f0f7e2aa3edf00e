#include "scene/overrides.hpp"

#include <fmt/format.h>

#include <charconv>
#include <memory>
#include <optional>
#include <stdexcept>

#include "base/error.hpp"
#include "scene/report.hpp"
#include "scene/study.hpp"

namespace shmoo::scene {
namespace {

constexpr std::size_t longest_path = 64;  // parts

class BadOverride : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts{""};
  bool quoted_part = false;
  for (const char character : path) {
    if (character == '"')
      quoted_part = !quoted_part;
    else if (character == '.' && !quoted_part)
      parts.emplace_back();
    else
      parts.back() += character;
  }
  if (quoted_part) throw BadOverride("a quote in the path is not closed");
  for (const auto& part : parts)
    if (part.empty()) throw BadOverride("the path has an empty part; write it like run.seed=7");
  if (parts.size() > longest_path) throw BadOverride("the path has too many parts");
  return parts;
}

// The value as TOML, or as text where it is no TOML and does not begin like a list, table or string.
toml::table parse_value(const std::string& value, const std::string& source) {
  try {
    toml::table parsed = toml::parse("value = " + value, source);
    if (parsed.size() == 1 && parsed.contains("value")) return parsed;
  } catch (const toml::parse_error& error) {
    if (!value.empty() && std::string_view("[{\"'").find(value.front()) != std::string_view::npos)
      throw BadOverride(fmt::format("the value is not TOML: {}", error.description()));
  }
  try {
    std::string escaped;
    for (const char character : value) {
      if (character == '"' || character == '\\') escaped += '\\';
      escaped += character;
    }
    return toml::parse("value = \"" + escaped + "\"", source);
  } catch (const toml::parse_error& error) {
    throw BadOverride(fmt::format("the value is not TOML: {}", error.description()));
  }
}

std::size_t entry(const toml::array& list, const std::string& part) {
  std::size_t index = 0;
  const auto [end, status] = std::from_chars(part.data(), part.data() + part.size(), index);
  if (status == std::errc{} && end == part.data() + part.size()) {
    if (index < list.size()) return index;
    throw BadOverride(fmt::format("there is no entry {}; the list has {}, numbered from 0", part, list.size()));
  }
  for (index = 0; index < list.size(); ++index) {
    const auto* candidate = list[index].as_table();
    if (candidate && (*candidate)["name"].value<std::string>() == part) return index;
  }
  throw BadOverride(fmt::format("{} is neither the number nor the name of an entry of the list", quoted(part)));
}

toml::node& step_into(toml::node& node, const std::string& part, const std::string& source) {
  if (auto* list = node.as_array()) return (*list)[entry(*list, part)];
  auto* table = node.as_table();
  if (!table)
    throw BadOverride(fmt::format("{} cannot be reached: what holds it is neither a table nor a list", quoted(part)));
  if (!table->contains(part)) {
    toml::table made = toml::parse("value = {}", source);
    table->insert_or_assign(part, std::move(*made["value"].as_table()));
  }
  return *table->get(part);
}

void replace(toml::node& holder, const std::string& part, toml::node& value) {
  std::move(value).visit([&](auto&& given) {
    if (auto* list = holder.as_array()) {
      const auto at = list->cbegin() + static_cast<std::ptrdiff_t>(entry(*list, part));
      list->replace(at, std::move(given));
    } else if (auto* table = holder.as_table()) {
      table->insert_or_assign(part, std::move(given));
    } else {
      throw BadOverride(fmt::format("{} cannot be set: what holds it is neither a table nor a list", quoted(part)));
    }
  });
}

void apply(toml::table& root, const std::string& path, const std::string& value, const std::string& source) {
  const auto parts = split(path);
  toml::table parsed = parse_value(value, source);
  toml::node* holder = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) holder = &step_into(*holder, parts[i], source);
  replace(*holder, parts.back(), *parsed.get("value"));
}

const toml::node* look_into(const toml::node& node, const std::string& part) {
  if (const auto* list = node.as_array()) return list->get(entry(*list, part));
  const auto* table = node.as_table();
  return table ? table->get(part) : nullptr;
}

}  // namespace

base::Measured number_in_model(const std::string& text, const std::string& path) {
  const toml::table root = toml::parse(text);
  const toml::node* node = &root;
  for (const auto& part : split(path)) {
    node = look_into(*node, part);
    if (!node) throw BadOverride("the model does not set it");
  }
  if (const auto* words = node->as_string()) return base::parse_quantity(words->get());
  if (const auto number = node->value<double>(); number && !node->is_boolean()) return {*number, {}};
  throw BadOverride("it is no number in the model");
}

void apply_overrides(toml::table& root, const Overrides& overrides) {
  std::vector<base::Diagnostic> diagnostics;
  for (const auto& [path, value] : overrides) {
    const std::string source = fmt::format("--set {}={}", path, value.substr(0, 200));
    try {
      apply(root, path, value, source);
    } catch (const BadOverride& error) {
      diagnostics.push_back({{source, 0, 0}, error.what()});
    }
  }
  if (!diagnostics.empty()) throw base::InputError(std::move(diagnostics));
}

}  // namespace shmoo::scene
