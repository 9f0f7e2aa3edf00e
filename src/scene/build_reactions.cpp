// Reactions: who takes part, at which rate, where.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "base/units.hpp"
#include "scene/build.hpp"
#include "scene/check.hpp"
#include "scene/equation.hpp"
#include "scene/surface.hpp"
#include "scene/well.hpp"

namespace shmoo::scene {
namespace {

constexpr int highest_order = 8;

// Terms merged by species, ascending. Empty `good` means that a name is unknown.
std::vector<Term> terms_of(const EquationSide& side, const Scene& scene, const Section& section, bool& good) {
  std::map<int, int> counts;
  for (const auto& [name, count] : side) {
    const int species = species_index(scene, name, section, "equation", *section.find("equation"));
    if (species < 0)
      good = false;
    else
      counts[species] += count;
  }
  std::vector<Term> terms;
  for (const auto& [species, count] : counts) terms.push_back({species, count});
  return terms;
}

int order_of(const std::vector<Term>& terms) {
  int order = 0;
  for (const Term& term : terms) order += term.count;
  return order;
}

bool same(const std::vector<Term>& a, const std::vector<Term>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Term& s, const Term& t) { return s.species == t.species && s.count == t.count; });
}

// The rate constant of one direction, checked against the order of the reaction; 0 with a message where it is wrong.
double rate_constant(const Section& section, std::string_view key, int order, bool per_area) {
  const auto text = section.text(key);
  if (!text) return 0;
  const base::Measured measured = base::parse_quantity(*text);
  base::Dimension wanted = base::dimensions::rate_constant(order);
  if (per_area) wanted = wanted * base::dimensions::length;
  if (measured.dimension == wanted) return measured.value;
  section.error(
      key, fmt::format("{} is {}; a reaction of order {} in this direction{} expects {}", quoted(*text),
                       base::dimension_name(measured.dimension), order,
                       per_area ? ", with nothing on the side of the first material," : "", base::expectation(wanted)));
  return 0;
}

// Which of forward, backward and rate go with the arrow.
bool check_rate_keys(const Section& section, bool reversible) {
  const auto before = section.report().count();
  const bool counted = section.has("propensity"), law = section.has("rate") || counted;
  const char* formula = counted ? "propensity" : "rate";
  if (counted && section.has("rate")) section.error("rate", "give either 'rate' or 'propensity', not both");
  if (law && reversible) section.error(formula, "a formula belongs to one direction; write two reactions with ->");
  if (law && section.has("forward"))
    section.error("forward", fmt::format("give either 'forward' or '{}', not both", formula));
  if (!reversible && section.has("backward"))
    section.error("backward", "the equation has no <->; write <->, or remove it");
  if (!law && !section.has("forward"))
    section.error("forward",
                  fmt::format("missing; give the rate constant{}", reversible ? "" : ", or a formula as 'rate'"));
  if (!law && reversible && !section.has("backward"))
    section.error("backward", "missing; the equation has <->, so give the rate constant from right to left");
  return section.report().count() == before;
}

// Materials in which all of these species live, and which the reaction is limited to.
std::vector<int> common_homes(const Scene& scene, const std::vector<int>& species, const std::vector<int>& limits) {
  std::vector<int> common = limits;
  if (limits.empty())
    for (std::size_t i = 0; i < scene.materials.size(); ++i) common.push_back(static_cast<int>(i));
  for (const int one : species) {
    const auto& homes = scene.species[static_cast<std::size_t>(one)].homes;
    std::vector<int> both;
    std::set_intersection(common.begin(), common.end(), homes.begin(), homes.end(), std::back_inserter(both));
    common = std::move(both);
  }
  return common;
}

void place(const Section& section, const Scene& scene, Reaction& reaction, const std::vector<int>& modifiers) {
  bool good = true;
  reaction.materials = material_list(scene, section, "in", good);
  std::vector<int> species = modifiers;
  for (const auto* side : {&reaction.reactants, &reaction.products})
    for (const Term& term : *side) species.push_back(term.species);
  const bool homeless = std::any_of(species.begin(), species.end(), [&](int one) {
    return scene.species[static_cast<std::size_t>(one)].homes.empty();
  });
  if (!good || homeless) return;
  const auto common = common_homes(scene, species, reaction.materials);
  if (common.empty())
    section.error(
        section.has("in") ? "in" : "equation",
        "its species share no material there, so it would never run; extend 'in' of the species or of the reaction");
  if (!reaction.materials.empty() || !modifiers.empty()) reaction.materials = common;
}

// The formula for v, or for events per second. Returns the species that it reads.
std::vector<int> read_law(const Section& section, const Draft& draft, Reaction& reaction) {
  if (const auto law = section.text("rate")) {
    reaction.expression = expanded(draft, *law);
    return check_formula(draft, section, "rate", *section.find("rate"),
                         base::dimensions::concentration / base::dimensions::time, Reads::rate_law);
  }
  const auto law = section.text("propensity");
  if (!law) return {};
  reaction.expression = expanded(draft, *law);
  reaction.per_volume = false;
  return check_numbers(draft, section, "propensity", *section.find("propensity"));
}

// Where a reaction runs in a volume of its own, that must be one.
void check_volume(const Section& section, const Draft& draft, const Reaction& reaction) {
  if (!draft.well || draft.compartments.empty() || !reaction.per_volume || volume_of(draft, reaction)) return;
  section.error("equation", fmt::format("its {} live in several compartments, so it has no volume to be counted in; "
                                        "give 'propensity', events per second, in place of '{}'",
                                        reaction.reactants.empty() ? "products" : "reactants",
                                        section.has("rate") ? "rate" : "forward"));
}

void add_reactions(const Section& section, Draft& draft, const Equation& equation) {
  bool good = true;
  Reaction forward;
  forward.reactants = terms_of(equation.left, draft, section, good);
  forward.products = terms_of(equation.right, draft, section, good);
  const bool rates = check_rate_keys(section, equation.reversible);
  if (!good) return;
  const int order = order_of(forward.reactants), backward_order = order_of(forward.products);
  if (same(forward.reactants, forward.products))
    return section.error("equation", "both sides are the same, so nothing would change");
  if (!section.has("propensity") && (order > highest_order || (equation.reversible && backward_order > highest_order)))
    return section.error("equation",
                         fmt::format("more than {} molecules would have to meet; split it into steps", highest_order));
  if (!rates || (section.has("surface") && !read_surface(section, draft, forward))) return;
  forward.name = section.text("name").value_or(section.text("equation").value_or(""));
  const auto modifiers = read_law(section, draft, forward);
  check_volume(section, draft, forward);
  forward.rate_constant = rate_constant(section, "forward", order, per_area(draft, forward));
  if (!on_surface(forward)) place(section, draft, forward, modifiers);
  if (!equation.reversible) return draft.reactions.push_back(std::move(forward));
  Reaction backward = forward;
  std::swap(backward.reactants, backward.products);
  check_volume(section, draft, backward);
  backward.rate_constant = rate_constant(section, "backward", backward_order, per_area(draft, backward));
  backward.name += " (backward)";
  forward.name += " (forward)";
  draft.reactions.push_back(std::move(forward));
  draft.reactions.push_back(std::move(backward));
}

}  // namespace

void build_reactions(const Section& root, Draft& draft) {
  for (const auto& section : root.sections("reaction")) {
    const auto text = section.text("equation");
    if (!text) continue;
    try {
      add_reactions(section, draft, parse_equation(*text));
    } catch (const EquationError& error) {
      section.error("equation", fmt::format("{}: {}", quoted(*text), error.what()));
    }
  }
}

}  // namespace shmoo::scene
