#include "rdme/network.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "rdme/expression.hpp"
#include "rdme/mass_action.hpp"

namespace shmoo::rdme {
namespace {

std::vector<Change> net_changes(const scene::Reaction& from) {
  std::map<int, int> net;
  for (const scene::Term& term : from.reactants) net[term.species] -= term.count;
  for (const scene::Term& term : from.products) net[term.species] += term.count;
  std::vector<Change> changes;
  for (const auto& [species, amount] : net) {
    if (amount != 0) changes.push_back({species, amount, false});
  }
  return changes;
}

template <class Container>
bool contains(const Container& values, int value) {
  return std::binary_search(values.begin(), values.end(), value);
}

}  // namespace

Network::Network(const scene::Scene& scene)
    : species_(scene.species), parameters_(scene.parameters.begin(), scene.parameters.end()) {
  std::vector<base::Diagnostic> mistakes;
  for (const scene::Species& one : species_) {
    if (!(one.diffusivity >= 0) || !std::isfinite(one.diffusivity)) {
      mistakes.push_back({{},
                          fmt::format("species {}: the diffusivity is {} m^2/s; it must be a finite number >= 0",
                                      one.name, one.diffusivity)});
    }
    any_smooth_ |= one.method != scene::SpeciesMethod::stochastic;
  }
  find_varying(scene);
  for (const scene::Reaction& reaction : scene.reactions) compile(reaction, scene.materials, mistakes);
  if (!mistakes.empty()) throw base::InputError(std::move(mistakes));
  sort_by_material(scene.materials.size());
  find_dependencies(scene.materials.size() + 1);
}

ExpressionNames expression_names(const Network& network) {
  ExpressionNames names{network.parameters(), {}};
  for (const scene::Species& one : network.species_list()) names.species.push_back(one.name);
  return names;
}

bool Network::lives_in(int species, int material) const { return contains(species_[species].homes, material); }

void Network::compile(const scene::Reaction& from, const std::vector<scene::Material>& materials,
                      std::vector<base::Diagnostic>& mistakes) {
  Reaction reaction;
  reaction.name = from.name;
  reaction.reactants = from.reactants;
  reaction.changes = net_changes(from);
  reaction.rate_constant = from.rate_constant;
  reaction.expression = from.expression;
  if (!from.per_volume) recognise_mass_action(reaction);
  reaction.surface = from.surface;
  std::set<int> reads;
  for (const scene::Term& term : reaction.reactants) {
    reaction.order += term.count;
    reads.insert(term.species);
  }
  if (!reaction.expression.empty()) {
    try {
      const Expression expression(from.expression, expression_names(*this));
      reads.insert(expression.reads().begin(), expression.reads().end());
      reaction.reads_time = expression.reads_time();
    } catch (const base::InputError& error) {
      for (const base::Diagnostic& one : error.diagnostics()) {
        mistakes.push_back({one.where, fmt::format("reaction {}: {}", from.name, one.message)});
      }
    }
  } else if (!(reaction.rate_constant >= 0) || !std::isfinite(reaction.rate_constant)) {
    mistakes.push_back({{},
                        fmt::format("reaction {}: the rate constant is {}; it must be a finite number >= 0", from.name,
                                    from.rate_constant)});
  }
  reaction.reads.assign(reads.begin(), reads.end());
  for (const Change& change : reaction.changes) {
    reaction.stochastic |= stochastic(change.species);
    reaction.langevin |= langevin(change.species);
  }
  reaction.langevin &= !reaction.stochastic;
  if (reaction.on_surface())
    divide(materials, reaction, mistakes);
  else
    find_materials(from, materials, reaction, mistakes);
  reactions_.push_back(std::move(reaction));
}

void Network::find_varying(const scene::Scene& scene) {
  std::set<int> varying;
  for (const scene::Event& event : scene.events) {
    for (const scene::Assignment& one : event.assignments) {
      for (std::size_t p = 0; p < parameters_.size(); ++p)
        if (parameters_[p].first == one.target) varying.insert(static_cast<int>(p));
    }
  }
  varying_.assign(varying.begin(), varying.end());
}

// Numbers of smooth species enter mass action as n^nu, so only single factors of them are the same.
void Network::recognise_mass_action(Reaction& reaction) const {
  if (reaction.expression.empty()) return;
  auto fixed = parameters_;
  for (auto varying = varying_.rbegin(); varying != varying_.rend(); ++varying) fixed.erase(fixed.begin() + *varying);
  auto law = as_mass_action(reaction.expression, expression_names(*this).species, fixed);
  if (!law) return;
  const auto factors_of = [&](int species) {
    for (const scene::Term& term : law->reactants)
      if (term.species == species) return term.count;
    return 0;
  };
  for (const scene::Term& term : law->reactants)
    if (term.count > 1 && !stochastic(term.species)) return;
  for (const scene::Term& term : reaction.reactants)  // it must be zero where reactants are short
    if (factors_of(term.species) < term.count) return;
  reaction.reactants = std::move(law->reactants);
  reaction.rate_constant = law->constant;
  reaction.expression.clear();
}

// Who of a reaction on a surface takes part in which of its two voxels.
void Network::divide(const std::vector<scene::Material>& materials, Reaction& reaction,
                     std::vector<base::Diagnostic>& mistakes) const {
  const auto [near, far] = reaction.surface;
  const auto check = [&](int species) {
    if (langevin(species)) {
      mistakes.push_back(
          {{},
           fmt::format("reaction {} runs on a surface, where noise is not smooth; set the method of species "
                       "{} to \"stochastic\" or \"deterministic\"",
                       reaction.name, name(species))});
    }
    if (lives_in(species, near) != lives_in(species, far)) return;
    mistakes.push_back({{},
                        fmt::format("reaction {} runs between {} and {}; species {} must live in just one of them",
                                    reaction.name, materials[near].name, materials[far].name, name(species))});
  };
  reaction.per_area = true;
  for (const scene::Term& term : reaction.reactants) {
    check(term.species);
    reaction.per_area = reaction.per_area && !lives_in(term.species, near);
  }
  for (Change& change : reaction.changes) {
    check(change.species);
    change.beyond = !lives_in(change.species, near);
  }
  if (!reaction.expression.empty())
    mistakes.push_back({{}, fmt::format("reaction {}: a formula cannot run on a surface", reaction.name)});
  reaction.in_material.assign(materials.size(), false);
  reaction.in_material[near] = true;
}

void Network::find_materials(const scene::Reaction& from, const std::vector<scene::Material>& materials,
                             Reaction& reaction, std::vector<base::Diagnostic>& mistakes) const {
  std::set<int> partners(reaction.reads.begin(), reaction.reads.end());
  for (const scene::Term& term : from.products) partners.insert(term.species);
  reaction.in_material.assign(materials.size(), from.materials.empty());
  for (int material : from.materials) reaction.in_material[material] = true;
  for (std::size_t material = 0; material < materials.size(); ++material) {
    for (int species : partners) {
      if (!reaction.in_material[material] || lives_in(species, static_cast<int>(material))) continue;
      reaction.in_material[material] = false;
      if (from.materials.empty()) continue;
      mistakes.push_back({{},
                          fmt::format("reaction {} is asked to run in material {}, where species {} does not live; "
                                      "add the material to the species' homes or take it out of the reaction",
                                      from.name, materials[material].name, name(species))});
    }
  }
  if (from.materials.empty() && std::ranges::find(reaction.in_material, true) == reaction.in_material.end()) {
    mistakes.push_back(
        {{}, fmt::format("reaction {} can run nowhere: its species have no material in common", from.name)});
  }
}

void Network::sort_by_material(std::size_t materials) {
  sampled_.resize(materials + 1);  // nothing runs in the last, of voxels that are vacant
  integrated_.resize(materials + 1);
  langevin_.resize(materials + 1);
  for (std::size_t r = 0; r < reactions_.size(); ++r) {
    const Reaction& reaction = reactions_[r];
    if (reaction.changes.empty()) continue;  // an event would change nothing
    (reaction.stochastic ? any_sampled_ : reaction.langevin ? any_langevin_ : any_integrated_) = true;
    samples_surfaces_ |= reaction.stochastic && reaction.on_surface();
    if (reaction.on_surface() && !reaction.stochastic) {
      integrated_on_surfaces_.push_back(static_cast<int>(r));
      continue;
    }
    sampled_time_ |= reaction.stochastic && reaction.reads_time;
    auto& lists = reaction.stochastic ? sampled_ : reaction.langevin ? langevin_ : integrated_;
    for (std::size_t material = 0; material < materials; ++material) {
      if (reaction.in_material[material]) lists[material].push_back(static_cast<int>(r));
    }
  }
}

void Network::find_dependencies(std::size_t materials) {
  for (std::size_t material = 0; material < materials; ++material) {
    std::vector<std::vector<int>> readers(species_.size());
    for (int r : sampled_[material]) {
      for (int species : reactions_[r].reads) readers[species].push_back(r);
    }
    for (const Reaction& reaction : reactions_) {
      std::set<int> touched;
      for (const Change& change : reaction.changes) {
        touched.insert(readers[change.species].begin(), readers[change.species].end());
      }
      after_reaction_.emplace_back(touched.begin(), touched.end());
    }
    std::ranges::move(readers, std::back_inserter(after_species_));
  }
}

}  // namespace shmoo::rdme
