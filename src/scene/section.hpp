#pragma once
// Typed access to a table that has been checked. Every accessor gives nothing where the key is absent or was found bad,
// so that no mistake is told twice.
#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "scene/report.hpp"
#include "scene/scene.hpp"

namespace shmoo::scene {

// Values of nodes that were checked.
double quantity_of(const toml::node& node);                                               // SI
std::vector<double> quantities_of(const toml::node& node);                                // a list of quantities, SI
Point point_of(const toml::node& node);                                                   // missing axes are 0
std::vector<std::pair<std::string, const toml::node*>> names_of(const toml::node& node);  // a text or a list of texts

class Section {
 public:
  Section(const toml::table& table, std::string path, Report& report)
      : table_(&table), path_(std::move(path)), report_(&report) {}

  const toml::node* find(std::string_view key) const { return table_->get(key); }
  bool has(std::string_view key) const { return find(key) != nullptr; }
  const toml::node* good(std::string_view key) const;  // present and not bad

  std::optional<double> quantity(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;
  std::optional<std::int64_t> integer(std::string_view key) const;
  std::optional<bool> boolean(std::string_view key) const;
  std::optional<std::string> text(std::string_view key) const;
  std::optional<Point> point(std::string_view key) const;
  std::vector<double> quantities(std::string_view key) const;
  std::vector<std::pair<std::string, const toml::node*>> names(std::string_view key) const;
  std::optional<Section> section(std::string_view key) const;
  std::vector<Section> sections(std::string_view key) const;                                // of a list of tables
  std::vector<std::pair<std::string, Section>> named_sections(std::string_view key) const;  // in the order of the names

  // Says what is wrong, at a key's value or, where the key is absent, at the table.
  void error(std::string_view key, const std::string& message) const;
  void error(const toml::node& at, std::string_view key, const std::string& message) const;
  void error(const std::string& message) const;

  const toml::table& table() const { return *table_; }
  const std::string& path() const { return path_; }
  Report& report() const { return *report_; }
  base::Location where() const { return report_->location(table_->source()); }

 private:
  const toml::table* table_;
  std::string path_;
  Report* report_;
};

}  // namespace shmoo::scene
