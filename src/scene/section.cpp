#include "scene/section.hpp"

#include <fmt/format.h>

#include "base/units.hpp"
#include "scene/check.hpp"

namespace shmoo::scene {

double quantity_of(const toml::node& node) {
  if (const auto* text = node.as_string()) return base::parse_quantity(text->get()).value;
  return node.value_or(0.0);
}

std::vector<double> quantities_of(const toml::node& node) {
  std::vector<double> values;
  if (const auto* list = node.as_array())
    for (const auto& entry : *list) values.push_back(quantity_of(entry));
  return values;
}

Point point_of(const toml::node& node) {
  Point point{};
  const auto values = quantities_of(node);
  for (std::size_t axis = 0; axis < values.size() && axis < point.size(); ++axis) point[axis] = values[axis];
  return point;
}

std::vector<std::pair<std::string, const toml::node*>> names_of(const toml::node& node) {
  std::vector<std::pair<std::string, const toml::node*>> names;
  if (const auto* text = node.as_string()) names.emplace_back(text->get(), &node);
  if (const auto* list = node.as_array())
    for (const auto& entry : *list)
      if (const auto* text = entry.as_string()) names.emplace_back(text->get(), &entry);
  return names;
}

const toml::node* Section::good(std::string_view key) const {
  const toml::node* node = find(key);
  return node && !report_->bad(*node) ? node : nullptr;
}

std::optional<double> Section::quantity(std::string_view key) const {
  const auto* node = good(key);
  return node && node->is_string() ? std::optional(quantity_of(*node)) : std::nullopt;
}

std::optional<double> Section::number(std::string_view key) const {
  const auto* node = good(key);
  return node ? node->value<double>() : std::nullopt;
}

std::optional<std::int64_t> Section::integer(std::string_view key) const {
  const auto* node = good(key);
  return node ? node->value<std::int64_t>() : std::nullopt;
}

std::optional<bool> Section::boolean(std::string_view key) const {
  const auto* node = good(key);
  return node ? node->value<bool>() : std::nullopt;
}

std::optional<std::string> Section::text(std::string_view key) const {
  const auto* node = good(key);
  return node ? node->value<std::string>() : std::nullopt;
}

std::optional<Point> Section::point(std::string_view key) const {
  const auto* node = good(key);
  return node ? std::optional(point_of(*node)) : std::nullopt;
}

std::vector<double> Section::quantities(std::string_view key) const {
  const auto* node = good(key);
  return node ? quantities_of(*node) : std::vector<double>{};
}

std::vector<std::pair<std::string, const toml::node*>> Section::names(std::string_view key) const {
  const auto* node = good(key);
  if (!node) return {};
  return names_of(*node);
}

std::optional<Section> Section::section(std::string_view key) const {
  const auto* node = find(key);
  const auto* inner = node ? node->as_table() : nullptr;
  if (!inner) return std::nullopt;
  return Section(*inner, join_path(path_, key), *report_);
}

std::vector<Section> Section::sections(std::string_view key) const {
  std::vector<Section> all;
  const auto* node = find(key);
  const auto* list = node ? node->as_array() : nullptr;
  if (!list) return all;
  for (std::size_t i = 0; i < list->size(); ++i)
    if (const auto* inner = (*list)[i].as_table())
      all.emplace_back(*inner, join_path(join_path(path_, key), std::to_string(i)), *report_);
  return all;
}

std::vector<std::pair<std::string, Section>> Section::named_sections(std::string_view key) const {
  std::vector<std::pair<std::string, Section>> all;
  const auto outer = section(key);
  if (!outer) return all;
  for (const auto& [name, value] : outer->table())
    if (const auto* inner = value.as_table())
      all.emplace_back(std::string(name.str()), Section(*inner, join_path(outer->path(), name.str()), *report_));
  return all;
}

void Section::error(std::string_view key, const std::string& message) const {
  const auto* node = find(key);
  error(node ? *node : *table_, key, message);
}

void Section::error(const toml::node& at, std::string_view key, const std::string& message) const {
  const std::string full = fmt::format("{}: {}", join_path(path_, key), message);
  // A table as a whole is never bad: what else it says still counts.
  if (&at == table_)
    report_->add(at.source(), full);
  else
    report_->add(at, full);
}

void Section::error(const std::string& message) const {
  report_->add(table_->source(), path_.empty() ? message : fmt::format("{}: {}", path_, message));
}

}  // namespace shmoo::scene
