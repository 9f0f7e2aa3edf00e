#include "scene/equation.hpp"

#include <fmt/format.h>

#include <charconv>

#include "scene/expression.hpp"
#include "scene/report.hpp"

namespace shmoo::scene {
namespace {

constexpr int largest_count = 1000;
constexpr std::size_t longest_equation = 1000;  // characters

std::string_view trim(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::pair<std::string, int> parse_term(std::string_view text) {
  const std::string_view term = trim(text);
  if (term.empty()) throw EquationError("there is nothing beside a '+'; write terms like A + 2 B");
  int count = 1;
  const auto [end, status] = std::from_chars(term.data(), term.data() + term.size(), count);
  const bool counted = status != std::errc::invalid_argument;
  const std::string name(counted ? trim(term.substr(static_cast<std::size_t>(end - term.data()))) : term);
  if (counted && (status != std::errc{} || count < 1 || count > largest_count))
    throw EquationError(fmt::format("the count in {} is not allowed; counts are whole numbers from 1 to {}",
                                    quoted(term), largest_count));
  if (!is_identifier(name))
    throw EquationError(fmt::format(
        "{} is no term; write the name of a species, after a whole number where there are several", quoted(term)));
  return {name, count};
}

EquationSide parse_side(std::string_view text) {
  const std::string_view side = trim(text);
  if (side.empty() || side == "0" || side == "nothing") return {};
  EquationSide terms;
  std::size_t begin = 0;
  while (true) {
    const auto plus = side.find('+', begin);
    terms.push_back(parse_term(side.substr(begin, plus == std::string_view::npos ? plus : plus - begin)));
    if (plus == std::string_view::npos) return terms;
    begin = plus + 1;
  }
}

}  // namespace

Equation parse_equation(std::string_view text) {
  if (text.size() > longest_equation)
    throw EquationError(fmt::format("more than {} characters; split it into several reactions", longest_equation));
  const auto arrow = text.find("->");
  if (arrow == std::string_view::npos)
    throw EquationError("there is no arrow; write -> for one direction or <-> for both");
  Equation equation;
  equation.reversible = arrow > 0 && text[arrow - 1] == '<';
  const auto rest = text.substr(arrow + 2);
  if (rest.find("->") != std::string_view::npos)
    throw EquationError("there are several arrows; write one equation for each");
  equation.left = parse_side(text.substr(0, equation.reversible ? arrow - 1 : arrow));
  equation.right = parse_side(rest);
  if (equation.left.empty() && equation.right.empty()) throw EquationError("both sides are empty");
  return equation;
}

}  // namespace shmoo::scene
