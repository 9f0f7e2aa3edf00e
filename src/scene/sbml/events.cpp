#include "scene/sbml/events.hpp"

#include <sbml/SBMLTypes.h>

namespace shmoo::scene::sbml {
namespace {

std::string assignment(const EventAssignment& one, const Model& model, const Symbols& symbols, Mistakes& mistakes) {
  const std::string& id = one.getVariable();
  const Species* species = model.getSpecies(id);
  if (!species && !model.getParameter(id) && !model.getCompartment(id)) {
    mistakes.add(one, fmt::format("'{}' is no species, parameter or compartment, and cannot be set", id));
    return "";
  }
  Formula value = symbols.formula(*one.getMath());
  if (species) value = symbols.molecules(*species, value);
  // Amounts in moles are hardly ever whole numbers of molecules.
  if (species && symbols.molecules_per_unit(*species) != 1 && symbols.role(id) == Role::reacting)
    value = call("rint", {value});
  return fmt::format("{} = \"{}\"", symbols.name(id), write(value));
}

}  // namespace

std::string event_table(const Event& event, const Model& model, const Symbols& symbols, Mistakes& mistakes) {
  if (event.getNumEventAssignments() == 0) return "";  // nothing happens
  std::string text = "\n[[event]]\n";
  if (event.isSetId()) text += fmt::format("name = \"{}\"\n", event.getId());
  try {
    const Trigger& trigger = *event.getTrigger();
    text += fmt::format("trigger = \"{}\"\n", write(symbols.formula(*trigger.getMath())));
    if (event.getDelay())
      text += fmt::format("delay = \"{}\"\n", write(product(symbols.formula(*event.getDelay()->getMath()),
                                                            number(symbols.seconds_per_unit()))));
    if (event.getPriority())
      text += fmt::format("priority = \"{}\"\n", write(symbols.formula(*event.getPriority()->getMath())));
    if (trigger.isSetInitialValue() && !trigger.getInitialValue()) text += "initially = false\n";
    if (trigger.isSetPersistent() && !trigger.getPersistent()) text += "persistent = false\n";
    if (event.isSetUseValuesFromTriggerTime() && !event.getUseValuesFromTriggerTime()) text += "values = \"event\"\n";
    std::string set;
    for (unsigned k = 0; k < event.getNumEventAssignments(); ++k)
      set += (set.empty() ? "" : ", ") + assignment(*event.getEventAssignment(k), model, symbols, mistakes);
    return text + fmt::format("set = {{ {} }}\n", set);
  } catch (const MathError& error) {
    mistakes.add(event, error.what());
  }
  return "";
}

}  // namespace shmoo::scene::sbml
