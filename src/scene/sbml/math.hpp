#pragma once
// MathML as formulas of the model file.
#include <sbml/math/ASTNode.h>

#include <functional>
#include <stdexcept>
#include <string>

#include "scene/formula.hpp"

class Model;

namespace shmoo::scene::sbml {

// What cannot be said in a formula.
class MathError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// What an identifier stands for, and the time.
using Meaning = std::function<Formula(const std::string& id)>;

// Function definitions of the model are written out. Throws MathError.
Formula formula_of(const ASTNode& node, const Model& model, const Meaning& meaning, const Formula& time);

// Products and quotients without factors of 1.
Formula product(const Formula& a, const Formula& b);
Formula quotient(const Formula& a, const Formula& b);

}  // namespace shmoo::scene::sbml
