// Events: what happens at a time or a condition.
#include <fmt/format.h>

#include <algorithm>

#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/expression.hpp"

namespace shmoo::scene {
namespace {

bool is_species(const Scene& scene, const std::string& name) {
  return std::any_of(scene.species.begin(), scene.species.end(), [&](const Species& one) { return one.name == name; });
}

// A formula of the event, its definitions written out; a quantity or a number stands for its value in SI units.
std::string formula_of(const Section& section, std::string_view key, const Draft& draft) {
  const auto* node = section.good(key);
  if (!node) return "";
  if (const auto value = node->value<double>()) return write(number(*value));
  const std::string text = node->value_or(std::string());
  if (looks_like_quantity(text)) return write(number(quantity_of(*node)));
  check_numbers(draft, section, key, *node);
  return expanded(draft, text);
}

void read_trigger(const Section& section, const Draft& draft, Event& event) {
  if (section.has("at") == section.has("trigger"))
    return section.error(section.has("at") ? "trigger" : "at", "give just one of 'at' and 'trigger'");
  event.trigger = section.has("at") ? fmt::format("t >= {}", formula_of(section, "at", draft))
                                    : formula_of(section, "trigger", draft);
}

void read_assignments(const Section& section, const Draft& draft, Event& event) {
  const auto set = section.section("set");
  if (!set) return;
  std::vector<std::string> known;
  for (const Species& one : draft.species) known.push_back(one.name);
  for (const auto& [name, value] : draft.parameters) known.push_back(name);
  for (const auto& [key, value] : set->table()) {
    const std::string name(key.str());
    const auto formula = formula_of(*set, name, draft);
    if (is_species(draft, name) || draft.parameters.contains(name)) {
      event.assignments.push_back({name, formula});
    } else if (!draft.bad_names.contains(name)) {
      set->error(name, fmt::format("no species or parameter is called {}{}", quoted(name),
                                   suggestion(name, known, fmt::format("there are: {}", listed(known)))));
    }
  }
  if (set->table().empty()) section.error("set", "is empty, so nothing would happen");
}

}  // namespace

void build_events(const Section& root, Draft& draft) {
  int number = 0;
  for (const auto& section : root.sections("event")) {
    Event event;
    event.where = section.where();
    event.name = section.text("name").value_or(fmt::format("event {}", ++number));
    read_trigger(section, draft, event);
    event.delay = formula_of(section, "delay", draft);
    event.priority = formula_of(section, "priority", draft);
    event.initially = section.boolean("initially").value_or(true);
    event.persistent = section.boolean("persistent").value_or(true);
    event.values_at_trigger = section.text("values").value_or("trigger") == "trigger";
    read_assignments(section, draft, event);
    draft.events.push_back(std::move(event));
  }
}

}  // namespace shmoo::scene
