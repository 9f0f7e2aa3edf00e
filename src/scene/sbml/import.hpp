#pragma once
// SBML (Level 2 and 3 core, read by libSBML) as a model file: a whole one, to be read by people and by Shmoo.
//
// What is taken over: compartments, species (amounts or concentrations as hasOnlySubstanceUnits says), parameters,
// local parameters, reactions with constant whole stoichiometries, assignment rules, initial assignments, function
// definitions, events. A kinetic law is a propensity: events per time, evaluated on the numbers there are. All else is
// named in an error.
#include <string>

namespace shmoo::scene {

// `text` is the SBML file `file`. Throws base::InputError with everything that is not supported.
std::string import_sbml(const std::string& text, const std::string& file);

}  // namespace shmoo::scene
