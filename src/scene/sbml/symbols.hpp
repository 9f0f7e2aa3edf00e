#pragma once
// What the identifiers of an SBML model become: names that formulas of a model file may use, what they stand for, and
// their values at the start.
#include <map>
#include <set>
#include <string>

#include "scene/formula.hpp"
#include "scene/sbml/math.hpp"
#include "scene/sbml/mistakes.hpp"

class Compartment;
class Model;
class Species;

namespace shmoo::scene::sbml {

enum class Role {
  reacting,  // a species that reactions change: a species here
  steered,   // what only events change: a parameter here
  ruled,     // what an assignment rule gives: a definition here
  fixed,     // what nothing changes: a parameter or, where it is a species, a definition
};

class Symbols {
 public:
  Symbols(const Model& model, Mistakes& mistakes);

  Role role(const std::string& id) const;
  const std::string& name(const std::string& id) const { return names_.at(id); }
  std::string local_name(const std::string& reaction, const std::string& id) const;

  // A formula of the model in names and numbers of molecules. Throws MathError.
  Formula formula(const ASTNode& math) const;
  // Of a kinetic law, whose local parameters hide all else.
  Formula formula(const ASTNode& math, const std::string& reaction, const std::set<std::string>& local) const;

  // The same as a number of molecules, where it is assigned to a species.
  Formula molecules(const Species& species, const Formula& value) const;

  double start(const std::string& id) const { return values_.at(names_.at(id)); }  // in the model's units
  double molecules_at_start(const Species& species) const;
  double molecules_per_unit(const Species& species) const;
  double seconds_per_unit() const { return seconds_; }
  double litres(const Compartment& compartment) const;

 private:
  void name_all();
  std::string free_name(const std::string& id) const;
  Formula meaning(const std::string& id) const;
  Formula size(const std::string& compartment) const;  // 1 where it is and stays so
  bool concentration(const Species& species) const;    // what its identifier stands for
  void evaluate();
  std::map<std::string, Formula> starting_formulas();

  const Model& model_;
  Mistakes& mistakes_;
  std::map<std::string, std::string> names_;
  std::map<std::string, double> values_;  // by name
  double seconds_ = 1;
};

}  // namespace shmoo::scene::sbml
