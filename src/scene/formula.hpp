#pragma once
// Formulas of the model file as trees, to look into and to change. What a text means is muParser's (expression.hpp);
// the tree follows its precedence: ?:, ||, &&, comparisons, + -, * / and signs, ^ from right to left.
#include <map>
#include <string>
#include <vector>

namespace shmoo::scene {

struct Formula {
  enum class Kind { number, name, call };  // call: a function, or an operator with its sign as word; "?:" has three
  Kind kind = Kind::number;
  double value = 0;
  std::string word;
  std::vector<Formula> of;
};

Formula number(double value);
Formula name(const std::string& word);
Formula call(const std::string& word, std::vector<Formula> of);

// Throws ExpressionError where the text is no formula. Names are not looked at.
Formula parse_formula(const std::string& text);

// A text that means the same, with as few brackets as that takes.
std::string write(const Formula& formula);

// Names exchanged for formulas.
Formula replace(const Formula& formula, const std::map<std::string, Formula>& names);

bool reads(const Formula& formula, const std::string& name);

}  // namespace shmoo::scene
