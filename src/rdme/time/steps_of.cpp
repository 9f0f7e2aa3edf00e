#include "rdme/time/steps_of.hpp"

#include <cctype>
#include <string_view>

namespace shmoo::rdme {
namespace {

// What binds no tighter than a comparison does.
bool separates(char c) { return std::string_view(",?:&|<>=!").find(c) != std::string_view::npos; }
bool in_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// From `at` on in direction `step`, up to what closes or separates.
std::string operand(const std::string& text, std::ptrdiff_t at, int step) {
  const char opens = step > 0 ? '(' : ')', closes = step > 0 ? ')' : '(';
  std::ptrdiff_t end = at;
  int depth = 0;
  for (; end >= 0 && end < std::ssize(text); end += step) {
    const char c = text[std::size_t(end)];
    if (c == opens) ++depth;
    if ((c == closes && depth-- == 0) || (depth == 0 && separates(c))) break;
  }
  return step > 0 ? text.substr(std::size_t(at), std::size_t(end - at))
                  : text.substr(std::size_t(end + 1), std::size_t(at - end));
}

void add_comparison(const std::string& text, std::size_t at, std::vector<StepSource>& sources) {
  const bool equal = at + 1 < text.size() && text[at + 1] == '=';
  const std::string sign = text.substr(at, equal ? 2 : 1);
  const std::string left = operand(text, std::ptrdiff_t(at) - 1, -1);
  const std::string right = operand(text, std::ptrdiff_t(at + sign.size()), 1);
  sources.push_back({"(" + left + ")" + sign + "(" + right + ")", "(" + left + ")-(" + right + ")"});
}

// Functions that jump, and a formula of their argument that is zero where they do.
struct Rounding {
  std::string_view name, before, behind;
};
constexpr Rounding roundings[] = {
    {"sign", "", ""}, {"rint", "cos(_pi*", ")"}, {"floor", "sin(_pi*", ")"}, {"ceil", "sin(_pi*", ")"}};

void add_rounding(const std::string& text, std::size_t at, std::vector<StepSource>& sources) {
  for (const auto& [name, before, behind] : roundings) {
    const std::size_t from = at + name.size();
    if (text.compare(at, name.size(), name) != 0 || from >= text.size() || text[from] != '(') continue;
    std::size_t end = from;
    for (int depth = 0; end < text.size(); ++end) {
      if (text[end] == '(') ++depth;
      if (text[end] == ')' && --depth == 0) break;
    }
    const std::string argument = text.substr(from, end - from + 1);
    sources.push_back({std::string(name) + argument, std::string(before) + argument + std::string(behind)});
  }
}

}  // namespace

std::vector<StepSource> steps_of(const std::string& formula) {
  std::vector<StepSource> sources;
  for (std::size_t at = 0; at < formula.size(); ++at) {
    if (formula[at] == '<' || formula[at] == '>') add_comparison(formula, at, sources);
    if (at == 0 || !in_name(formula[at - 1])) add_rounding(formula, at, sources);
  }
  return sources;
}

}  // namespace shmoo::rdme
