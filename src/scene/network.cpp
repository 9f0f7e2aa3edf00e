#include "scene/network.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "scene/document.hpp"
#include "scene/sbml/import.hpp"

namespace shmoo::scene {
namespace {

void join(toml::table& own, toml::table&& network) {
  for (auto&& [key, value] : network) {
    toml::node* known = own.get(key);
    if (!known) {
      own.insert(key, std::move(value));
    } else if (known->is_table() && value.is_table()) {
      join(*known->as_table(), std::move(*value.as_table()));
    } else if (known->is_array() && value.is_array()) {
      toml::array both = std::move(*value.as_array());
      for (auto&& one : *known->as_array()) both.push_back(std::move(one));
      *known->as_array() = std::move(both);
    }
  }
}

}  // namespace

bool resolve_network(toml::table& root, const std::string& file) {
  const auto* node = root.get("network");
  const auto* name = node ? node->as_string() : nullptr;
  if (!name) return false;
  const auto path = (std::filesystem::path(file).parent_path() / name->get()).string();
  auto network = toml::parse(import_sbml(read_bytes(path, "network"), path), path + " (imported)");
  root.erase("network");
  join(root, std::move(network));
  return true;
}

}  // namespace shmoo::scene
