#include "scene/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/random.hpp"
#include "scene/report.hpp"

namespace shmoo::scene {
namespace {

// '=' that is no comparison: muParser would change a variable.
bool assigns(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=') {
      ++i;
      continue;
    }
    if (i == 0 || std::string_view("<>!=").find(text[i - 1]) == std::string_view::npos) return true;
  }
  return false;
}

std::string explain(const mu::Parser::exception_type& error, const std::vector<std::string>& variables) {
  if (error.GetCode() != mu::ecUNASSIGNABLE_TOKEN) return error.GetMsg();
  std::vector<std::string> names = variables;
  names.insert(names.end(), reserved_names().begin(), reserved_names().end());
  const std::string token = error.GetToken().substr(0, 64);
  const std::string name =
      token.substr(0, token.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"));
  if (name.empty()) return fmt::format("'{}' does not belong there", token);
  return fmt::format("'{}' is not defined{}", name,
                     suggestion(name, names, fmt::format("names here: {}", listed(variables))));
}

// muParser's own functions and two that it lacks.
void add_functions(mu::Parser& parser) {
  parser.DefineFun("floor", [](double x) { return std::floor(x); });
  parser.DefineFun("ceil", [](double x) { return std::ceil(x); });
}

}  // namespace

struct Expression::Compiled {
  mu::Parser parser;
  std::vector<double> values;
  std::vector<bool> used;
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables)
    : compiled_(std::make_unique<Compiled>()) {
  auto& [parser, values, used] = *compiled_;
  if (assigns(text)) throw ExpressionError("a formula does not assign; write == to compare");
  if (text.find('"') != std::string::npos) throw ExpressionError("a formula holds no text in quotes");
  values.assign(variables.size(), 1.0);
  used.assign(variables.size(), false);
  add_functions(parser);
  try {
    for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &values[i]);
    parser.SetExpr(text);
    int results = 0;
    parser.Eval(results);  // before GetUsedVar, which forgives undefined names
    if (results != 1) throw ExpressionError(fmt::format("a formula has one value, not {}", results));
    for (const auto& [name, address] : parser.GetUsedVar()) {
      const auto found = std::find(variables.begin(), variables.end(), name);
      if (found != variables.end()) used[static_cast<std::size_t>(found - variables.begin())] = true;
    }
  } catch (const mu::Parser::exception_type& error) {
    throw ExpressionError(explain(error, variables));
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;
Expression& Expression::operator=(Expression&&) noexcept = default;

double Expression::operator()(const std::vector<double>& values) const {
  compiled_->values = values;  // same size: the addresses stay
  return compiled_->parser.Eval();
}

bool Expression::uses(std::size_t variable) const { return compiled_->used[variable]; }

const std::vector<std::string>& reserved_names() {
  static const std::vector<std::string> names = [] {
    mu::Parser parser;
    add_functions(parser);
    std::vector<std::string> all;
    for (const auto& [name, function] : parser.GetFunDef()) all.push_back(name);
    for (const auto& [name, value] : parser.GetConst()) all.push_back(name);
    return all;
  }();
  return names;
}

bool is_identifier(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return !name.empty() && letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

namespace {

constexpr int random_points = 64;
constexpr double same = 1e-6;  // relative; scaling by powers of two is exact but for roots and the like

using Exponent = int base::Dimension::*;
constexpr std::array<std::pair<Exponent, std::string_view>, 7> units{{{&base::Dimension::length, "m"},
                                                                      {&base::Dimension::mass, "kg"},
                                                                      {&base::Dimension::time, "s"},
                                                                      {&base::Dimension::temperature, "K"},
                                                                      {&base::Dimension::amount, "molecule"},
                                                                      {&base::Dimension::current, "A"},
                                                                      {&base::Dimension::luminosity, "cd"}}};

std::vector<double> random_point(const std::vector<Variable>& variables, base::RandomSequence& random) {
  std::vector<double> point;
  for (const auto& [name, dimension, lower, upper, logarithmic] : variables) {
    const double u = random.uniform();
    point.push_back(logarithmic ? lower * std::pow(upper / lower, u) : lower + (upper - lower) * u);
  }
  return point;
}

// The base unit in whose change the formula fails at this point, or "".
std::string_view failing_unit(const Expression& expression, const std::vector<Variable>& variables,
                              const base::Dimension& dimension, const std::vector<double>& point, double value) {
  for (const auto& [exponent, name] : units) {
    for (const int shift : {1, 10, -10}) {
      std::vector<double> scaled = point;
      for (std::size_t i = 0; i < point.size(); ++i)
        scaled[i] = std::ldexp(point[i], shift * (variables[i].dimension.*exponent));
      const double changed = std::ldexp(expression(scaled), -shift * (dimension.*exponent));
      if (std::isfinite(changed) && std::abs(changed - value) > same * std::max(std::abs(value), std::abs(changed)))
        return name;
    }
  }
  return "";
}

}  // namespace

void check_dimension(const Expression& expression, const std::vector<Variable>& variables,
                     const base::Dimension& dimension) {
  base::RandomSequence random({}, base::Stream::test);
  bool finite = false;
  for (int i = 0; i < random_points; ++i) {
    const auto point = random_point(variables, random);
    const double value = expression(point);
    if (!std::isfinite(value)) continue;
    finite = true;
    const auto failing = failing_unit(expression, variables, dimension, point, value);
    if (failing.empty()) continue;
    throw ExpressionError(
        fmt::format("the formula is not {}: its units of {} do not match; name quantities under [parameters] instead "
                    "of writing bare numbers",
                    base::dimension_name(dimension), failing));
  }
  if (!finite) throw ExpressionError("the formula has no finite value at any of the points that were tried");
}

void check_not_negative(const Expression& expression, const std::vector<Variable>& variables) {
  base::RandomSequence random({}, base::Stream::test);
  double lowest = 0, largest = 0;
  for (int i = 0; i < 4 * random_points; ++i) {
    const double value = expression(random_point(variables, random));
    if (!std::isfinite(value)) continue;
    lowest = std::min(lowest, value);
    largest = std::max(largest, std::abs(value));
  }
  if (lowest < -same * largest)
    throw ExpressionError(fmt::format(
        "the formula is negative somewhere ({:.3g} in SI units); a concentration is not; use max(0, ...)", lowest));
}

}  // namespace shmoo::scene
