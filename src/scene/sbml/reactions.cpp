#include "scene/sbml/reactions.hpp"

#include <sbml/SBMLTypes.h>

#include <cmath>

namespace shmoo::scene::sbml {
namespace {

constexpr double most = 1000;  // of one species in an equation

class Writer {
 public:
  Writer(const Reaction& reaction, const Model& model, const Symbols& symbols, Mistakes& mistakes)
      : reaction_(reaction), model_(model), symbols_(symbols), mistakes_(mistakes) {}

  std::string table() {
    for (unsigned k = 0; k < reaction_.getNumReactants(); ++k) add(*reaction_.getReactant(k), -1);
    for (unsigned k = 0; k < reaction_.getNumProducts(); ++k) add(*reaction_.getProduct(k), 1);
    const std::string left = side(-1), right = side(1);
    if (left == right) return "";  // both are "0"
    return fmt::format("\n[[reaction]]\nname = \"{}\"\nequation = \"{} -> {}\"\npropensity = \"{}\"\n",
                       reaction_.getId(), left, right, propensity());
  }

 private:
  void add(const SpeciesReference& reference, int sign) {
    const Species* species = model_.getSpecies(reference.getSpecies());
    if (!species) return mistakes_.add(reference, fmt::format("there is no species '{}'", reference.getSpecies()));
    if (symbols_.role(species->getId()) == Role::ruled && !species->getBoundaryCondition())
      mistakes_.add(*species, "a reaction and a rule both change it");
    if (symbols_.role(species->getId()) != Role::reacting) return;
    if (species->isSetConversionFactor() || model_.isSetConversionFactor())
      mistakes_.add(*species, "conversion factors are not supported");
    change_[species->getId()] += sign * stoichiometry(reference);
    const double unit = symbols_.molecules_per_unit(*species);
    if (unit_ != 0 && unit != unit_) mistakes_.add(reaction_, "its species have different units of substance");
    unit_ = unit;
  }

  double stoichiometry(const SpeciesReference& reference) {
    double value = reference.isSetStoichiometry() || model_.getLevel() < 3 ? reference.getStoichiometry() : 1.0;
    const ASTNode* math = reference.isSetStoichiometryMath() ? reference.getStoichiometryMath()->getMath() : nullptr;
    const std::string& id = reference.getId();
    if (const auto* initial = id.empty() ? nullptr : model_.getInitialAssignment(id)) math = initial->getMath();
    if (math && math->isNumber())
      value = math->getValue();
    else if (math)
      mistakes_.add(reference, "only a number can be its stoichiometry");
    if (!id.empty() && model_.getAssignmentRule(id))
      mistakes_.add(reference, "rules for stoichiometries are not supported");
    if (value != std::floor(value) || std::abs(value) > most)
      mistakes_.add(reaction_, fmt::format("the stoichiometry {} of '{}' is no whole number up to {}", value,
                                           reference.getSpecies(), most));
    return value;
  }

  std::string side(int sign) const {
    std::string text;
    for (const auto& [id, change] : change_) {
      if (change * sign <= 0) continue;
      const auto number = std::abs(change) == 1 ? "" : fmt::format("{} ", std::abs(change));
      text += (text.empty() ? "" : " + ") + number + symbols_.name(id);
    }
    return text.empty() ? "0" : text;
  }

  // Events per second: the law counts the model's units of substance in its units of time.
  std::string propensity() {
    const KineticLaw& law = *reaction_.getKineticLaw();
    std::set<std::string> local;
    for (unsigned k = 0; k < law.getNumParameters(); ++k) local.insert(law.getParameter(k)->getId());
    try {
      const Formula events = product(symbols_.formula(*law.getMath(), reaction_.getId(), local), number(unit_));
      return write(quotient(events, number(symbols_.seconds_per_unit())));
    } catch (const MathError& error) {
      mistakes_.add(reaction_, error.what());
      return "0";
    }
  }

  const Reaction& reaction_;
  const Model& model_;
  const Symbols& symbols_;
  Mistakes& mistakes_;
  std::map<std::string, double> change_;
  double unit_ = 0;  // molecules
};

}  // namespace

std::string reaction_table(const Reaction& reaction, const Model& model, const Symbols& symbols, Mistakes& mistakes) {
  return Writer(reaction, model, symbols, mistakes).table();
}

}  // namespace shmoo::scene::sbml
