#include "scene/sbml/refuse.hpp"

#include <sbml/SBMLTypes.h>
#include <sbml/extension/SBasePlugin.h>

namespace shmoo::scene::sbml {
namespace {

constexpr unsigned most_errors = 20;

void refuse_reaction(const Reaction& reaction, Mistakes& mistakes) {
  if (reaction.isSetFast() && reaction.getFast()) mistakes.add(reaction, "fast reactions are not supported");
  const KineticLaw* law = reaction.getKineticLaw();
  if (!law || !law->getMath()) mistakes.add(reaction, "it has no kinetic law, so its rate is not known");
}

void refuse_event(const Event& event, Mistakes& mistakes) {
  if (!event.getTrigger() || !event.getTrigger()->getMath()) mistakes.add(event, "it has no trigger");
  if (event.getDelay() && !event.getDelay()->getMath()) mistakes.add(event, "its delay has no mathematics");
  if (event.getPriority() && !event.getPriority()->getMath()) mistakes.add(event, "its priority has no mathematics");
  for (unsigned k = 0; k < event.getNumEventAssignments(); ++k)
    if (!event.getEventAssignment(k)->getMath()) mistakes.add(*event.getEventAssignment(k), "it has no mathematics");
}

// libSBML adds plugins of its own accord to documents that do not ask for them: only what the file declares counts. The
// extended mathematics is looked at formula by formula.
void refuse_packages(SBMLDocument& document, Mistakes& mistakes) {
  const XMLNamespaces* declared = document.getNamespaces();
  for (unsigned k = 0; k < document.getNumPlugins() && document.getLevel() > 2; ++k) {
    const SBasePlugin& plugin = *document.getPlugin(k);
    const auto& package = plugin.getPackageName();
    if (!declared || !declared->containsUri(plugin.getURI()) || package == "l3v2extendedmath") continue;
    if (document.getPackageRequired(package))
      mistakes.add(document, fmt::format("the package '{}' is required, and not supported", package));
  }
}

}  // namespace

void refuse_unsupported(SBMLDocument& document, Mistakes& mistakes) {
  for (unsigned k = 0, told = 0; k < document.getNumErrors() && told < most_errors; ++k) {
    const SBMLError& error = *document.getError(k);
    if (error.getSeverity() < LIBSBML_SEV_ERROR && error.getErrorId() != RequiredPackagePresent) continue;
    mistakes.add(static_cast<int>(error.getLine()), error.getShortMessage() + ": " + error.getMessage());
    ++told;
  }
  refuse_packages(document, mistakes);
  const Model* model = document.getModel();
  if (!model) return mistakes.add(1, "the file holds no SBML model");
  for (unsigned k = 0; k < model->getNumRules(); ++k) {
    const Rule& rule = *model->getRule(k);
    if (!rule.isAssignment())
      mistakes.add(rule, fmt::format("{} are not supported{}", rule.isRate() ? "rate rules" : "algebraic rules",
                                     rule.isRate() ? "; it is for '" + rule.getVariable() + "'" : ""));
    else if (!rule.getMath())
      mistakes.add(rule, "it has no mathematics");
  }
  for (unsigned k = 0; k < model->getNumConstraints(); ++k)
    mistakes.add(*model->getConstraint(k), "constraints are not supported");
  for (unsigned k = 0; k < model->getNumReactions(); ++k) refuse_reaction(*model->getReaction(k), mistakes);
  for (unsigned k = 0; k < model->getNumEvents(); ++k) refuse_event(*model->getEvent(k), mistakes);
}

}  // namespace shmoo::scene::sbml
