#pragma once
// Formulas of the model file, read by muParser: its operators, functions and constants (_pi, _e), and the names given.
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/units.hpp"

namespace shmoo::scene {

// What is wrong with a formula.
class ExpressionError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A formula compiled for variables in a fixed order. Not to be evaluated by two threads at once.
class Expression {
 public:
  // Throws ExpressionError: a syntax error, an undefined name (with the nearest one), an assignment, more than one
  // value.
  Expression(const std::string& text, const std::vector<std::string>& variables);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  double operator()(const std::vector<double>& values) const;  // in the order of `variables`
  bool uses(std::size_t variable) const;

 private:
  struct Compiled;
  std::unique_ptr<Compiled> compiled_;
};

// The names that muParser gives a meaning: functions and constants.
const std::vector<std::string>& reserved_names();

// True for letters, digits and _, not beginning with a digit.
bool is_identifier(const std::string& name);

struct Variable {
  std::string name;
  base::Dimension dimension;
  double lower = 1, upper = 1;  // SI; typical values, tried at random between them
  bool logarithmic = false;     // tried evenly in the logarithm; lower > 0 then
};

// Throws ExpressionError unless the formula has the dimension: it is evaluated at random points in units that differ by
// powers of two, and must change as the dimension says. Also where no point gives a finite value.
void check_dimension(const Expression& expression, const std::vector<Variable>& variables,
                     const base::Dimension& dimension);

// Throws ExpressionError where the formula is negative at one of the random points; rounding is forgiven.
void check_not_negative(const Expression& expression, const std::vector<Variable>& variables);

}  // namespace shmoo::scene
