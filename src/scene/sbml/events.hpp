#pragma once
// Events of an SBML model as tables of a model file.
#include <string>

#include "scene/sbml/symbols.hpp"

class Event;

namespace shmoo::scene::sbml {

std::string event_table(const Event& event, const Model& model, const Symbols& symbols, Mistakes& mistakes);

}  // namespace shmoo::scene::sbml
