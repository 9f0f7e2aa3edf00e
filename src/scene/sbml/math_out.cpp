#include "scene/sbml/math_out.hpp"

#include <fmt/format.h>

#include <map>

#include "scene/expression.hpp"

namespace shmoo::scene::sbml {
namespace {

using Kind = Formula::Kind;

const std::map<std::string, ASTNodeType_t> operators{
    {"+", AST_PLUS},           {"-", AST_MINUS},           {"*", AST_TIMES},           {"/", AST_DIVIDE},
    {"^", AST_POWER},          {"||", AST_LOGICAL_OR},     {"&&", AST_LOGICAL_AND},    {"<", AST_RELATIONAL_LT},
    {">", AST_RELATIONAL_GT},  {"<=", AST_RELATIONAL_LEQ}, {">=", AST_RELATIONAL_GEQ}, {"==", AST_RELATIONAL_EQ},
    {"!=", AST_RELATIONAL_NEQ}};
const std::map<std::string, ASTNodeType_t> functions{
    {"abs", AST_FUNCTION_ABS},       {"acos", AST_FUNCTION_ARCCOS},   {"acosh", AST_FUNCTION_ARCCOSH},
    {"asin", AST_FUNCTION_ARCSIN},   {"asinh", AST_FUNCTION_ARCSINH}, {"atan", AST_FUNCTION_ARCTAN},
    {"atanh", AST_FUNCTION_ARCTANH}, {"ceil", AST_FUNCTION_CEILING},  {"cos", AST_FUNCTION_COS},
    {"cosh", AST_FUNCTION_COSH},     {"exp", AST_FUNCTION_EXP},       {"floor", AST_FUNCTION_FLOOR},
    {"ln", AST_FUNCTION_LN},         {"log", AST_FUNCTION_LN},        {"sin", AST_FUNCTION_SIN},
    {"sinh", AST_FUNCTION_SINH},     {"tan", AST_FUNCTION_TAN},       {"tanh", AST_FUNCTION_TANH}};

std::unique_ptr<ASTNode> node(ASTNodeType_t type, const std::vector<Formula>& parts = {}) {
  auto made = std::make_unique<ASTNode>(type);
  for (const Formula& part : parts) made->addChild(math_of(part).release());
  return made;
}

bool is_truth(const Formula& formula) {
  static const std::string signs = "|| && < > <= >= == !=";
  return formula.kind == Kind::call && formula.of.size() == 2 && signs.find(formula.word) != std::string::npos;
}

// A number as a truth and a truth as a number, which SBML tells apart.
Formula truth(const Formula& formula) { return is_truth(formula) ? formula : call("!=", {formula, number(0)}); }

Formula with_truths(const Formula& formula) {
  Formula made = formula;
  const bool joins = formula.word == "&&" || formula.word == "||", chooses = formula.word == "?:";
  for (std::size_t k = 0; k < made.of.size(); ++k) {
    Formula& part = made.of[k];
    if (joins || (chooses && k == 0))
      part = truth(part);
    else if (is_truth(part))
      part = call("?:", {part, number(1), number(0)});
  }
  return made;
}

std::unique_ptr<ASTNode> name_node(const std::string& word) {
  if (word == "_pi") return node(AST_CONSTANT_PI);
  if (word == "_e") return node(AST_CONSTANT_E);
  auto made = node(word == "t" ? AST_NAME_TIME : AST_NAME);
  made->setName(word.c_str());
  return made;
}

}  // namespace

std::unique_ptr<ASTNode> condition_of(const Formula& formula) { return math_of(truth(formula)); }

std::unique_ptr<ASTNode> math_of(const Formula& given) {
  if (given.kind == Kind::number) {
    auto made = std::make_unique<ASTNode>();
    made->setValue(given.value);
    return made;
  }
  if (given.kind == Kind::name) return name_node(given.word);
  const Formula formula = with_truths(given);
  const auto& [word, of] = std::tie(formula.word, formula.of);
  if (word == "?:") return node(AST_FUNCTION_PIECEWISE, {of[1], of[0], of[2]});
  if (const auto sign = operators.find(word); sign != operators.end()) return node(sign->second, of);
  if (const auto function = functions.find(word); function != functions.end()) return node(function->second, of);
  if (word == "sqrt") return node(AST_FUNCTION_ROOT, {number(2), of.at(0)});
  if (word == "log10") return node(AST_FUNCTION_LOG, {number(10), of.at(0)});
  if (word == "log2") return node(AST_FUNCTION_LOG, {number(2), of.at(0)});
  if (word == "sum") return node(AST_PLUS, of);
  if (word == "min" || word == "max") {
    Formula best = of.at(0);
    for (std::size_t k = 1; k < of.size(); ++k)
      best = call("?:", {call(word == "min" ? "<" : ">", {best, of[k]}), best, of[k]});
    return math_of(best);
  }
  if (word == "sign")
    return math_of(call("?:", {call(">", {of.at(0), number(0)}), number(1),
                               call("?:", {call("<", {of[0], number(0)}), number(-1), number(0)})}));
  if (word == "rint") return node(AST_FUNCTION_FLOOR, {call("+", {of.at(0), number(0.5)})});
  throw ExpressionError(fmt::format("SBML has no function '{}'", word));
}

}  // namespace shmoo::scene::sbml
