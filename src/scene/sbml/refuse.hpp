#pragma once
#include "scene/sbml/mistakes.hpp"

class SBMLDocument;

namespace shmoo::scene::sbml {

// Names every element of a kind that is not supported.
void refuse_unsupported(SBMLDocument& document, Mistakes& mistakes);

}  // namespace shmoo::scene::sbml
