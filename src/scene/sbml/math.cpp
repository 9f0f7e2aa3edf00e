#include "scene/sbml/math.hpp"

#include <fmt/format.h>
#include <sbml/FunctionDefinition.h>
#include <sbml/Model.h>

#include <map>
#include <numbers>

namespace shmoo::scene::sbml {
namespace {

constexpr int deepest = 200;  // functions in functions and brackets in brackets

bool is_number(const Formula& formula, double value) {
  return formula.kind == Formula::Kind::number && formula.value == value;
}

// Functions of one argument whose names differ only in spelling.
const std::map<int, std::string> functions{
    {AST_FUNCTION_ABS, "abs"},       {AST_FUNCTION_ARCCOS, "acos"},   {AST_FUNCTION_ARCCOSH, "acosh"},
    {AST_FUNCTION_ARCSIN, "asin"},   {AST_FUNCTION_ARCSINH, "asinh"}, {AST_FUNCTION_ARCTAN, "atan"},
    {AST_FUNCTION_ARCTANH, "atanh"}, {AST_FUNCTION_CEILING, "ceil"},  {AST_FUNCTION_COS, "cos"},
    {AST_FUNCTION_COSH, "cosh"},     {AST_FUNCTION_EXP, "exp"},       {AST_FUNCTION_FLOOR, "floor"},
    {AST_FUNCTION_LN, "ln"},         {AST_FUNCTION_SIN, "sin"},       {AST_FUNCTION_SINH, "sinh"},
    {AST_FUNCTION_TAN, "tan"},       {AST_FUNCTION_TANH, "tanh"}};
const std::map<int, std::string> reciprocals{{AST_FUNCTION_SEC, "cos"},   {AST_FUNCTION_CSC, "sin"},
                                             {AST_FUNCTION_COT, "tan"},   {AST_FUNCTION_SECH, "cosh"},
                                             {AST_FUNCTION_CSCH, "sinh"}, {AST_FUNCTION_COTH, "tanh"}};
const std::map<int, std::string> comparisons{{AST_RELATIONAL_EQ, "=="},  {AST_RELATIONAL_NEQ, "!="},
                                             {AST_RELATIONAL_GT, ">"},   {AST_RELATIONAL_LT, "<"},
                                             {AST_RELATIONAL_GEQ, ">="}, {AST_RELATIONAL_LEQ, "<="}};

Formula negation(const Formula& a) { return call("?:", {a, number(0), number(1)}); }

class Translation {
 public:
  Translation(const Model& model, const Meaning& meaning, const Formula& time)
      : model_(model), meaning_(meaning), time_(time) {}

  Formula of(const ASTNode& node, int depth = 0) const {
    if (depth > deepest) throw MathError("its mathematics is nested too deep");
    std::vector<Formula> parts;
    for (unsigned k = 0; k < node.getNumChildren(); ++k) parts.push_back(of(*node.getChild(k), depth + 1));
    const int type = node.getType();
    if (const auto same = functions.find(type); same != functions.end()) return call(same->second, need(1, parts));
    if (const auto one = reciprocals.find(type); one != reciprocals.end())
      return call("/", {number(1), call(one->second, need(1, parts))});
    if (const auto sign = comparisons.find(type); sign != comparisons.end()) return chain(sign->second, parts);
    if (node.isNumber()) return number(node.getValue());
    if (type == AST_FUNCTION) return user_function(node, parts, depth);
    if (node.isLogical()) return logical(type, parts);
    return arithmetic(node, type, parts);
  }

 private:
  static const std::vector<Formula>& need(std::size_t count, const std::vector<Formula>& parts) {
    if (parts.size() != count)
      throw MathError(fmt::format("a function has {} arguments where {} belong", parts.size(), count));
    return parts;
  }

  static Formula fold(const std::string& word, const std::vector<Formula>& parts, double empty) {
    if (parts.empty()) return number(empty);
    Formula all = parts.front();
    for (std::size_t k = 1; k < parts.size(); ++k) all = call(word, {all, parts[k]});
    return all;
  }

  // a < b < c
  static Formula chain(const std::string& sign, const std::vector<Formula>& parts) {
    std::vector<Formula> pairs;
    for (std::size_t k = 1; k < parts.size(); ++k) pairs.push_back(call(sign, {parts[k - 1], parts[k]}));
    return fold("&&", pairs, 1);
  }

  Formula arithmetic(const ASTNode& node, int type, const std::vector<Formula>& parts) const {
    switch (type) {
      case AST_NAME:
        return meaning_(node.getName());
      case AST_NAME_TIME:
        return time_;
      case AST_NAME_AVOGADRO:
        return number(node.getValue());
      case AST_CONSTANT_E:
        return number(std::numbers::e);
      case AST_CONSTANT_PI:
        return number(std::numbers::pi);
      case AST_CONSTANT_TRUE:
        return number(1);
      case AST_CONSTANT_FALSE:
        return number(0);
      case AST_PLUS:
        return fold("+", parts, 0);
      case AST_TIMES:
        return fold("*", parts, 1);
      case AST_MINUS:
        return parts.size() == 1 ? call("-", parts) : call("-", need(2, parts));
      case AST_DIVIDE:
        return call("/", need(2, parts));
      case AST_POWER:
      case AST_FUNCTION_POWER:
        return call("^", need(2, parts));
      case AST_FUNCTION_ROOT:
        if (parts.size() == 1 || is_number(need(2, parts)[0], 2)) return call("sqrt", {parts.back()});
        return call("^", {parts[1], call("/", {number(1), parts[0]})});
      case AST_FUNCTION_LOG:
        if (parts.size() == 1 || is_number(need(2, parts)[0], 10)) return call("log10", {parts.back()});
        return call("/", {call("ln", {parts[1]}), call("ln", {parts[0]})});
      case AST_FUNCTION_MIN:
        return call("min", parts);
      case AST_FUNCTION_MAX:
        return call("max", parts);
      case AST_FUNCTION_PIECEWISE:
        return piecewise(parts);
      case AST_FUNCTION_DELAY:
        throw MathError("the symbol 'delay' looks back in time, which is not supported");
      case AST_FUNCTION_RATE_OF:
        throw MathError("the symbol 'rateOf' is not supported");
      default:
        break;
    }
    throw MathError(fmt::format("its mathematics uses '{}', which is not supported",
                                node.getName() ? node.getName() : fmt::format("operation {}", type)));
  }

  static Formula logical(int type, const std::vector<Formula>& parts) {
    if (type == AST_LOGICAL_AND) return fold("&&", parts, 1);
    if (type == AST_LOGICAL_OR) return fold("||", parts, 0);
    if (type == AST_LOGICAL_NOT) return negation(need(1, parts)[0]);
    if (type == AST_LOGICAL_IMPLIES) return call("||", {negation(need(2, parts)[0]), parts[1]});
    if (type != AST_LOGICAL_XOR) throw MathError("its mathematics uses a logical operator that is not supported");
    Formula odd = number(0);
    for (const Formula& part : parts) odd = call("!=", {odd, call("!=", {part, number(0)})});
    return odd;
  }

  static Formula piecewise(const std::vector<Formula>& parts) {
    if (parts.size() % 2 == 0)
      throw MathError("a piecewise without 'otherwise' has no value where no piece holds, which is not supported");
    Formula all = parts.back();
    for (std::size_t k = parts.size() - 1; k >= 2; k -= 2) all = call("?:", {parts[k - 1], parts[k - 2], all});
    return all;
  }

  Formula user_function(const ASTNode& node, const std::vector<Formula>& parts, int depth) const {
    const FunctionDefinition* function = model_.getFunctionDefinition(node.getName());
    if (!function || !function->getBody()) throw MathError(fmt::format("there is no function '{}'", node.getName()));
    std::map<std::string, Formula> arguments;
    need(function->getNumArguments(), parts);
    for (unsigned k = 0; k < function->getNumArguments(); ++k)
      arguments[function->getArgument(k)->getName()] = parts[k];
    const Meaning inner = [&](const std::string& id) {
      const auto found = arguments.find(id);
      return found == arguments.end() ? meaning_(id) : found->second;
    };
    return Translation(model_, inner, time_).of(*function->getBody(), depth + 1);
  }

  const Model& model_;
  const Meaning& meaning_;
  const Formula& time_;
};

}  // namespace

Formula formula_of(const ASTNode& node, const Model& model, const Meaning& meaning, const Formula& time) {
  return Translation(model, meaning, time).of(node);
}

Formula product(const Formula& a, const Formula& b) {
  if (is_number(a, 1)) return b;
  if (is_number(b, 1)) return a;
  return call("*", {a, b});
}

Formula quotient(const Formula& a, const Formula& b) { return is_number(b, 1) ? a : call("/", {a, b}); }

}  // namespace shmoo::scene::sbml
