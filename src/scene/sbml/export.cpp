#include "scene/sbml/export.hpp"

#include <fmt/format.h>
#include <sbml/SBMLTypes.h>

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "scene/expression.hpp"
#include "scene/sbml/math_out.hpp"
#include "scene/well.hpp"

namespace shmoo::scene {
namespace {

constexpr double litres_per_volume = 1000;  // of 1 m^3

// A scene with particles as one well.
Scene as_well(Scene scene, double volume) {
  scene.compartments.push_back({"all", volume});
  for (scene::Species& one : scene.species) one.compartment = 0;
  return scene;
}

// c n (n - 1) ... of a reaction in numbers.
Formula law_of(const Scene& scene, const scene::Reaction& reaction) {
  if (!reaction.expression.empty()) return parse_formula(reaction.expression);
  Formula law = number(reaction.rate_constant);
  for (const Term& term : reaction.reactants) {
    const Formula n = name(scene.species[static_cast<std::size_t>(term.species)].name);
    for (int k = 0; k < term.count; ++k) law = call("*", {law, k == 0 ? n : call("-", {n, number(k)})});
  }
  return law;
}

class Export {
 public:
  Export(const Scene& said, const std::vector<double>& molecules, double volume)
      : said_(well_mixed(said) ? said : as_well(said, volume)), scene_(in_numbers(said_)), molecules_(molecules) {
    model_ = document_.createModel();
    if (!scene_.title.empty()) model_->setName(scene_.title);
    model_->setSubstanceUnits("item");
    model_->setExtentUnits("item");
    model_->setTimeUnits("second");
    model_->setVolumeUnits("litre");
    if (well_mixed(said)) return;
    model_->setNotes(
        "<body xmlns=\"http://www.w3.org/1999/xhtml\"><p>The chemistry of a scene with particles, as if all of its "
        "domain "
        "were one well: diffusion, flow, walls and materials are left out.</p></body>");
  }

  std::string text() {
    for (const scene::Compartment& one : said_.compartments) add(one);
    for (std::size_t s = 0; s < scene_.species.size(); ++s) add(scene_.species[s], molecules_.at(s));
    for (const auto& [parameter, value] : scene_.parameters) add(parameter, value);
    for (const Definition& one : scene_.definitions) add(one);
    for (std::size_t r = 0; r < scene_.reactions.size(); ++r) add(scene_.reactions[r], r);
    for (std::size_t e = 0; e < scene_.events.size(); ++e) add(scene_.events[e], e);
    if (!mistakes_.empty()) throw base::InputError(std::move(mistakes_));
    const std::unique_ptr<char, decltype(&free)> bytes(writeSBMLToString(&document_), &free);
    return bytes.get();
  }

 private:
  // Calls use(math); what cannot be said is a mistake of `owner`.
  template <class Use>
  void say(const std::string& owner, const Formula& formula, const Use& use) {
    try {
      for (const char* axis : {"x", "y", "z"})
        if (scene_.dimension > 0 && reads(formula, axis))
          throw ExpressionError(fmt::format("it reads the place '{}', which SBML has none of", axis));
      use(sbml::math_of(formula).get());
    } catch (const ExpressionError& error) {
      mistakes_.push_back({{said_.file, 0, 0}, fmt::format("{}: {}", owner, error.what())});
    }
  }

  // Compartments of a model file may be called like a parameter or species; identifiers of SBML may not.
  std::string id_of(const scene::Compartment& one) const {
    const auto called = [&](const std::string& id) {
      const auto same = [&](const auto& other) { return other.name == id; };
      return scene_.parameters.contains(id) || std::any_of(scene_.species.begin(), scene_.species.end(), same) ||
             std::any_of(scene_.definitions.begin(), scene_.definitions.end(), same);
    };
    std::string id = one.name;
    while (called(id)) id += "_compartment";
    return id;
  }

  void add(const scene::Compartment& one) {
    auto& made = *model_->createCompartment();
    made.setId(id_of(one));
    made.setSpatialDimensions(3.0);
    made.setSize(one.volume * litres_per_volume);
    made.setConstant(true);
  }

  void add(const scene::Species& one, double molecules) {
    auto& made = *model_->createSpecies();
    made.setId(one.name);
    made.setCompartment(id_of(said_.compartments[static_cast<std::size_t>(one.compartment)]));
    made.setInitialAmount(molecules);
    made.setSubstanceUnits("item");
    made.setHasOnlySubstanceUnits(true);
    made.setBoundaryCondition(false);
    made.setConstant(false);
  }

  void add(const std::string& parameter, double value) {
    const auto sets = [&](const Assignment& one) { return one.target == parameter; };
    const bool varies = std::any_of(scene_.events.begin(), scene_.events.end(), [&](const scene::Event& event) {
      return std::any_of(event.assignments.begin(), event.assignments.end(), sets);
    });
    auto& made = *model_->createParameter();
    made.setId(parameter);
    made.setValue(value);
    made.setConstant(!varies);
  }

  void add(const Definition& one) {
    auto& made = *model_->createParameter();
    made.setId(one.name);
    made.setConstant(false);
    auto& rule = *model_->createAssignmentRule();
    rule.setVariable(one.name);
    say("definition " + one.name, parse_formula(one.expression), [&](const ASTNode* math) { rule.setMath(math); });
  }

  void add(const scene::Reaction& one, std::size_t index) {
    auto& made = *model_->createReaction();
    made.setId(is_identifier(one.name) && !model_->getElementBySId(one.name) ? one.name
                                                                             : fmt::format("reaction_{}", index + 1));
    made.setName(one.name);
    made.setReversible(false);
    made.setFast(false);
    const auto refer = [&](const Term& term, SpeciesReference& to) {
      to.setSpecies(scene_.species[static_cast<std::size_t>(term.species)].name);
      to.setStoichiometry(term.count);
      to.setConstant(true);
    };
    for (const Term& term : one.reactants) refer(term, *made.createReactant());
    for (const Term& term : one.products) refer(term, *made.createProduct());
    const Formula law = law_of(scene_, one);
    for (const scene::Species& species : scene_.species) {
      const auto takes_part = [&](const Term& term) {
        return scene_.species[static_cast<std::size_t>(term.species)].name == species.name;
      };
      const bool known = std::any_of(one.reactants.begin(), one.reactants.end(), takes_part) ||
                         std::any_of(one.products.begin(), one.products.end(), takes_part);
      if (!known && reads(law, species.name)) made.createModifier()->setSpecies(species.name);
    }
    say("reaction " + one.name, law, [&](const ASTNode* math) { made.createKineticLaw()->setMath(math); });
  }

  void add(const scene::Event& one, std::size_t index) {
    auto& made = *model_->createEvent();
    made.setId(is_identifier(one.name) && !model_->getElementBySId(one.name) ? one.name
                                                                             : fmt::format("event_{}", index + 1));
    made.setUseValuesFromTriggerTime(one.values_at_trigger);
    auto& trigger = *made.createTrigger();
    trigger.setInitialValue(one.initially);
    trigger.setPersistent(one.persistent);
    const std::string owner = "event " + one.name;
    trigger.setMath(sbml::condition_of(parse_formula(one.trigger)).get());
    if (!one.delay.empty())
      say(owner, parse_formula(one.delay), [&](const ASTNode* math) { made.createDelay()->setMath(math); });
    if (!one.priority.empty())
      say(owner, parse_formula(one.priority), [&](const ASTNode* math) { made.createPriority()->setMath(math); });
    for (const Assignment& set : one.assignments) {
      auto& to = *made.createEventAssignment();
      to.setVariable(set.target);
      say(owner, parse_formula(set.expression), [&](const ASTNode* math) { to.setMath(math); });
    }
  }

  Scene said_, scene_;
  const std::vector<double>& molecules_;
  SBMLDocument document_{3, 1};
  Model* model_ = nullptr;
  std::vector<base::Diagnostic> mistakes_;
};

}  // namespace

std::string export_sbml(const Scene& scene, const std::vector<double>& molecules, double volume) {
  return Export(scene, molecules, volume).text();
}

}  // namespace shmoo::scene
