#include "scene/sbml/import.hpp"

#include <sbml/SBMLReader.h>
#include <sbml/SBMLTypes.h>

#include <cmath>
#include <memory>

#include "scene/sbml/events.hpp"
#include "scene/sbml/reactions.hpp"
#include "scene/sbml/refuse.hpp"
#include "scene/sbml/units.hpp"

namespace shmoo::scene {
namespace sbml {
namespace {

constexpr double round_off = 1e-9;  // relative, of initial numbers

// TOML's text in quotes.
std::string quoted_text(const std::string& text) {
  std::string plain;
  for (const char c : text) plain += c == '"' || c == '\\' || static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  return "\"" + plain + "\"";
}

class Import {
 public:
  Import(const Model& model, const std::string& file, Mistakes& mistakes)
      : model_(model), file_(file), mistakes_(mistakes), symbols_(model, mistakes) {}

  std::string text() {
    const auto& title = model_.isSetName() ? model_.getName() : model_.getId();
    std::string all = fmt::format("title = {}\n", quoted_text(title.empty() ? file_ : title)) + remarks();
    all += compartments() + parameters() + definitions() + species();
    for (unsigned k = 0; k < model_.getNumReactions(); ++k)
      all += reaction_table(*model_.getReaction(k), model_, symbols_, mistakes_);
    for (unsigned k = 0; k < model_.getNumEvents(); ++k)
      all += event_table(*model_.getEvent(k), model_, symbols_, mistakes_);
    return all + observables() +
           fmt::format(
               "\n[run]  # SBML says nothing of this\nuntil = \"{0:g} s\"\nrecord_every = \"{1:g} s\"\nrealisations = "
               "1000\n",
               50 * symbols_.seconds_per_unit(), symbols_.seconds_per_unit());
  }

 private:
  std::string remarks() const {
    const auto told = [&](Quantity quantity, const char* otherwise) {
      const auto unit = declared_unit(model_, quantity);
      return unit.empty() ? std::string("not declared, taken as ") + otherwise : "declared as " + unit;
    };
    return fmt::format(
        "# From {}. Formulas are of pure numbers in the model's own units, but species stand for molecules and t for "
        "seconds.\n"
        "# Units: substance {}; volume {}; time {}.\n",
        file_, told(Quantity::substance, "molecules"), told(Quantity::volume, "litres"),
        told(Quantity::time, "seconds"));
  }

  std::string compartments() const {
    std::string text;
    for (unsigned k = 0; k < model_.getNumCompartments(); ++k) {
      const Compartment& one = *model_.getCompartment(k);
      text += fmt::format("\n[compartments.{}]\nvolume = \"{} L\"{}\n", symbols_.name(one.getId()),
                          symbols_.litres(one), symbols_.role(one.getId()) == Role::fixed ? "" : "  # at the start");
    }
    return text.empty() ? "\n[compartments.all]\nvolume = \"1 L\"\n" : text;
  }

  std::string parameters() const {
    std::string text;
    const auto add = [&](const std::string& name, double value) { text += fmt::format("{} = {}\n", name, value); };
    const auto is_parameter = [&](const std::string& id) {
      const Role role = symbols_.role(id);
      return role == Role::steered || (role == Role::fixed && !model_.getSpecies(id));
    };
    for (unsigned k = 0; k < model_.getNumCompartments(); ++k) {
      const auto& id = model_.getCompartment(k)->getId();
      if (is_parameter(id)) add(symbols_.name(id), symbols_.start(id));
    }
    for (unsigned k = 0; k < model_.getNumParameters(); ++k) {
      const auto& id = model_.getParameter(k)->getId();
      if (is_parameter(id)) add(symbols_.name(id), symbols_.start(id));
    }
    for (unsigned k = 0; k < model_.getNumSpecies(); ++k) {
      const Species& one = *model_.getSpecies(k);
      if (is_parameter(one.getId())) add(symbols_.name(one.getId()), symbols_.molecules_at_start(one));
    }
    for (unsigned k = 0; k < model_.getNumReactions(); ++k) {
      const Reaction& reaction = *model_.getReaction(k);
      for (unsigned p = 0; p < reaction.getKineticLaw()->getNumParameters(); ++p) {
        const Parameter& one = *reaction.getKineticLaw()->getParameter(p);
        if (!one.isSetValue()) mistakes_.add(one, fmt::format("in reaction '{}' it has no value", reaction.getId()));
        add(symbols_.local_name(reaction.getId(), one.getId()), one.isSetValue() ? one.getValue() : 1);
      }
    }
    return text.empty() ? "" : "\n[parameters]\n" + text;
  }

  std::string definitions() const {
    std::string text;
    for (unsigned k = 0; k < model_.getNumSpecies(); ++k) {
      const Species& one = *model_.getSpecies(k);
      if (symbols_.role(one.getId()) == Role::fixed)
        text += fmt::format("{} = {}\n", symbols_.name(one.getId()), symbols_.molecules_at_start(one));
    }
    for (unsigned k = 0; k < model_.getNumRules(); ++k) {
      const Rule& rule = *model_.getRule(k);
      if (model_.getSpeciesReference(rule.getVariable())) continue;  // refused with its reaction
      try {
        Formula value = symbols_.formula(*rule.getMath());
        if (const Species* species = model_.getSpecies(rule.getVariable())) value = symbols_.molecules(*species, value);
        text += fmt::format("{} = \"{}\"\n", symbols_.name(rule.getVariable()), write(value));
      } catch (const MathError& error) {
        mistakes_.add(rule, fmt::format("for '{}': {}", rule.getVariable(), error.what()));
      }
    }
    return text.empty() ? "" : "\n[definitions]\n" + text;
  }

  std::string species() const {
    std::string text;
    for (unsigned k = 0; k < model_.getNumSpecies(); ++k) {
      const Species& one = *model_.getSpecies(k);
      if (symbols_.role(one.getId()) != Role::reacting) continue;
      const Compartment* home = model_.getCompartment(one.getCompartment());
      if (!home) {
        mistakes_.add(one, fmt::format("there is no compartment '{}'", one.getCompartment()));
        continue;
      }
      const double molecules = symbols_.molecules_at_start(one), whole = std::rint(molecules);
      const bool is_whole = std::abs(molecules - whole) <= round_off * std::max(1.0, whole);
      if (!(molecules >= 0)) mistakes_.add(one, fmt::format("its amount at the start is {}", molecules));
      text += fmt::format("\n[species.{}]\nin = \"{}\"\n", symbols_.name(one.getId()), symbols_.name(home->getId()));
      text += is_whole ? fmt::format("initial = \"{} molecules\"\n", whole)
                       : fmt::format("initial = \"{} molecules/L\"  # {} molecules: more or fewer by chance\n",
                                     molecules / symbols_.litres(*home), molecules);
    }
    return text;
  }

  std::string observables() const {
    std::string text;
    for (unsigned k = 0; k < model_.getNumSpecies(); ++k) {
      const auto& id = model_.getSpecies(k)->getId();
      if (symbols_.role(id) != Role::reacting) continue;
      text += fmt::format("\n[[observable]]\nname = \"{0}\"\ntype = \"count\"\nspecies = \"{0}\"\n", symbols_.name(id));
    }
    return text;
  }

  const Model& model_;
  const std::string& file_;
  Mistakes& mistakes_;
  Symbols symbols_;
};

}  // namespace
}  // namespace sbml

std::string import_sbml(const std::string& text, const std::string& file) {
  const std::unique_ptr<SBMLDocument> document(readSBMLFromString(text.c_str()));
  sbml::Mistakes mistakes(file);
  sbml::refuse_unsupported(*document, mistakes);
  mistakes.finish();
  auto model = sbml::Import(*document->getModel(), file, mistakes).text();
  mistakes.finish();
  return model;
}

}  // namespace shmoo::scene
