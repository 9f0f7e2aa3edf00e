#pragma once
// Reactions of an SBML model as tables of a model file.
#include <string>

#include "scene/sbml/symbols.hpp"

class Reaction;

namespace shmoo::scene::sbml {

// "[[reaction]]" with what it changes and its propensity; "" where it changes nothing.
std::string reaction_table(const Reaction& reaction, const Model& model, const Symbols& symbols, Mistakes& mistakes);

}  // namespace shmoo::scene::sbml
