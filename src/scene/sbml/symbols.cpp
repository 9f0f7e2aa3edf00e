#include "scene/sbml/symbols.hpp"

#include <sbml/SBMLTypes.h>

#include <algorithm>
#include <array>

#include "scene/expression.hpp"
#include "scene/sbml/units.hpp"

namespace shmoo::scene::sbml {
namespace {

bool reactions_change(const Model& model, const std::string& id) {
  for (unsigned r = 0; r < model.getNumReactions(); ++r) {
    const Reaction& reaction = *model.getReaction(r);
    for (unsigned k = 0; k < reaction.getNumReactants(); ++k)
      if (reaction.getReactant(k)->getSpecies() == id) return true;
    for (unsigned k = 0; k < reaction.getNumProducts(); ++k)
      if (reaction.getProduct(k)->getSpecies() == id) return true;
  }
  return false;
}

bool events_change(const Model& model, const std::string& id) {
  for (unsigned e = 0; e < model.getNumEvents(); ++e)
    for (unsigned k = 0; k < model.getEvent(e)->getNumEventAssignments(); ++k)
      if (model.getEvent(e)->getEventAssignment(k)->getVariable() == id) return true;
  return false;
}

bool exists(const Model& model, const std::string& id) {
  return model.getSpecies(id) || model.getParameter(id) || model.getCompartment(id);
}

}  // namespace

Symbols::Symbols(const Model& model, Mistakes& mistakes) : model_(model), mistakes_(mistakes) {
  if (const auto unit = declared_unit(model, Quantity::time); !unit.empty()) {
    const auto size = unit_size(model, unit, Quantity::time);
    if (!size) mistakes_.add(model, fmt::format("its unit of time '{}' is no time", unit));
    seconds_ = size.value_or(1.0);
  }
  name_all();
  evaluate();
}

Role Symbols::role(const std::string& id) const {
  if (model_.getAssignmentRule(id)) return Role::ruled;
  const Species* species = model_.getSpecies(id);
  if (species && !species->getBoundaryCondition() && !species->getConstant() && reactions_change(model_, id))
    return Role::reacting;
  return events_change(model_, id) ? Role::steered : Role::fixed;
}

std::string Symbols::free_name(const std::string& id) const {
  const auto& reserved = reserved_names();
  constexpr std::array more{"t", "nothing"};
  const auto taken = [&](const std::string& name) {
    if (std::find(reserved.begin(), reserved.end(), name) != reserved.end()) return true;
    if (std::find(more.begin(), more.end(), name) != more.end()) return true;
    const auto same = [&](const auto& known) { return known.second == name; };
    return std::any_of(names_.begin(), names_.end(), same);
  };
  std::string name = id;
  while (taken(name) || (name != id && exists(model_, name))) name += '_';
  return name;
}

void Symbols::name_all() {
  const auto add = [&](const SBase& element) { names_[element.getId()] = free_name(element.getId()); };
  for (unsigned k = 0; k < model_.getNumCompartments(); ++k) add(*model_.getCompartment(k));
  for (unsigned k = 0; k < model_.getNumSpecies(); ++k) add(*model_.getSpecies(k));
  for (unsigned k = 0; k < model_.getNumParameters(); ++k) add(*model_.getParameter(k));
  for (unsigned k = 0; k < model_.getNumReactions(); ++k) {
    const KineticLaw* law = model_.getReaction(k)->getKineticLaw();
    for (unsigned p = 0; law && p < law->getNumParameters(); ++p) {
      const std::string id = model_.getReaction(k)->getId() + "_" + law->getParameter(p)->getId();
      names_[model_.getReaction(k)->getId() + "." + law->getParameter(p)->getId()] = free_name(id);
    }
  }
}

std::string Symbols::local_name(const std::string& reaction, const std::string& id) const {
  return names_.at(reaction + "." + id);
}

bool Symbols::concentration(const Species& species) const {
  const Compartment* home = model_.getCompartment(species.getCompartment());
  return !species.getHasOnlySubstanceUnits() && home && home->getSpatialDimensions() != 0;
}

Formula Symbols::size(const std::string& compartment) const {
  const bool stays = role(compartment) == Role::fixed;
  const auto known = values_.find(names_.at(compartment));
  if (stays && known != values_.end() && known->second == 1) return number(1);
  return scene::name(names_.at(compartment));
}

double Symbols::molecules_per_unit(const Species& species) const {
  std::string unit = species.getSubstanceUnits();
  if (unit.empty()) unit = declared_unit(model_, Quantity::substance);
  if (unit.empty()) return 1;
  const auto size = unit_size(model_, unit, Quantity::substance);
  if (!size) mistakes_.add(species, fmt::format("its unit '{}' counts no molecules; use mole or item", unit));
  return size.value_or(1.0);
}

Formula Symbols::meaning(const std::string& id) const {
  const auto known = names_.find(id);
  if (known == names_.end()) {
    if (model_.getReaction(id))
      throw MathError(fmt::format("it reads the rate of reaction '{}', which is not supported", id));
    if (model_.getSpeciesReference(id))
      throw MathError(fmt::format("it reads the stoichiometry '{}', which is not supported", id));
    throw MathError(fmt::format("there is nothing called '{}'", id));
  }
  if (model_.getCompartment(id)) return size(id);
  const Species* species = model_.getSpecies(id);
  Formula value = scene::name(known->second);
  if (!species) return value;
  value = quotient(value, number(molecules_per_unit(*species)));
  return concentration(*species) ? quotient(value, size(species->getCompartment())) : value;
}

Formula Symbols::formula(const ASTNode& math) const { return formula(math, "", {}); }

Formula Symbols::formula(const ASTNode& math, const std::string& reaction, const std::set<std::string>& local) const {
  const Meaning symbol = [&](const std::string& id) {
    return local.contains(id) ? scene::name(local_name(reaction, id)) : meaning(id);
  };
  return formula_of(math, model_, symbol, quotient(scene::name("t"), number(seconds_)));
}

Formula Symbols::molecules(const Species& species, const Formula& value) const {
  const Formula amount = concentration(species) ? product(value, size(species.getCompartment())) : value;
  return product(amount, number(molecules_per_unit(species)));
}

double Symbols::molecules_at_start(const Species& species) const {
  const double volume = concentration(species) ? start(species.getCompartment()) : 1.0;
  return start(species.getId()) * volume * molecules_per_unit(species);
}

double Symbols::litres(const Compartment& compartment) const {
  std::string unit = compartment.getUnits();
  if (unit.empty()) unit = declared_unit(model_, Quantity::volume);
  const auto known = unit.empty() ? std::optional(1.0) : unit_size(model_, unit, Quantity::volume);
  const double size = start(compartment.getId()) * known.value_or(1.0);
  return size > 0 ? size : 1.0;
}

// What gives each identifier its value at time 0, in plain identifiers: species by what their identifier stands for.
std::map<std::string, Formula> Symbols::starting_formulas() {
  std::map<std::string, Formula> formulas;
  const Meaning symbol = [&](const std::string& id) {
    if (!names_.contains(id)) throw MathError(fmt::format("'{}' has no value at the start", id));
    return scene::name(names_.at(id));
  };
  const auto take = [&](const SBase& element, const ASTNode* math) {
    const auto& id = element.getId();
    if (const auto* rule = model_.getAssignmentRule(id)) math = rule->getMath();
    if (const auto* initial = model_.getInitialAssignment(id)) math = initial->getMath();
    if (!math) return false;
    try {
      formulas[names_.at(id)] = formula_of(*math, model_, symbol, number(0));
    } catch (const MathError& error) {
      mistakes_.add(element, error.what());
    }
    return true;
  };
  for (unsigned k = 0; k < model_.getNumCompartments(); ++k) {
    const Compartment& one = *model_.getCompartment(k);
    if (!take(one, nullptr)) formulas[names_.at(one.getId())] = number(one.isSetSize() ? one.getSize() : 1.0);
  }
  for (unsigned k = 0; k < model_.getNumParameters(); ++k) {
    const Parameter& one = *model_.getParameter(k);
    if (take(one, nullptr)) continue;
    if (!one.isSetValue()) mistakes_.add(one, "it has no value");
    formulas[names_.at(one.getId())] = number(one.isSetValue() ? one.getValue() : 1);
  }
  for (unsigned k = 0; k < model_.getNumSpecies(); ++k) {
    const Species& one = *model_.getSpecies(k);
    if (take(one, nullptr)) continue;
    const Formula home = scene::name(names_.at(one.getCompartment()));
    const bool per_volume = concentration(one), given = one.isSetInitialConcentration();
    const Formula value = number(given                      ? one.getInitialConcentration()
                                 : one.isSetInitialAmount() ? one.getInitialAmount()
                                                            : 0);
    formulas[names_.at(one.getId())] = given == per_volume ? value
                                       : given             ? call("*", {value, home})
                                                           : call("/", {value, home});
  }
  return formulas;
}

void Symbols::evaluate() {
  auto formulas = starting_formulas();
  for (bool progress = true; progress;) {
    progress = false;
    for (auto next = formulas.begin(); next != formulas.end();) {
      const auto waits = [&](const auto& other) { return reads(next->second, other.first); };
      if (std::any_of(formulas.begin(), formulas.end(), waits)) {
        ++next;
        continue;
      }
      std::vector<std::string> names;
      std::vector<double> values;
      for (const auto& [name, value] : values_) names.push_back(name), values.push_back(value);
      try {
        values_[next->first] = Expression(write(next->second), names)(values);
      } catch (const ExpressionError& error) {
        mistakes_.add(model_,
                      fmt::format("the value of '{}' at the start cannot be found: {}", next->first, error.what()));
        values_[next->first] = 1;
      }
      next = formulas.erase(next);
      progress = true;
    }
  }
  for (const auto& [name, formula] : formulas) {
    mistakes_.add(model_, fmt::format("the value of '{}' at the start depends on itself", name));
    values_[name] = 1;
  }
}

}  // namespace shmoo::scene::sbml
