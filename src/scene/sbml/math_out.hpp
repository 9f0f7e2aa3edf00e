#pragma once
// Formulas of the model file as MathML.
#include <sbml/math/ASTNode.h>

#include <memory>

#include "scene/formula.hpp"

namespace shmoo::scene::sbml {

// `t` becomes the time. Throws ExpressionError where SBML has no such function.
std::unique_ptr<ASTNode> math_of(const Formula& formula);

// The same where SBML wants a truth: what is not zero.
std::unique_ptr<ASTNode> condition_of(const Formula& formula);

}  // namespace shmoo::scene::sbml
