#include "scene/formula.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "scene/expression.hpp"

namespace shmoo::scene {
namespace {

using Kind = Formula::Kind;

// Binary operators from weak to strong; "?:" is weaker than all.
const std::array<std::vector<std::string_view>, 5> levels{
    {{"||"}, {"&&"}, {"<=", ">=", "!=", "==", "<", ">"}, {"+", "-"}, {"*", "/"}}};

constexpr int deepest = 500;  // brackets in brackets

class Parser {
 public:
  explicit Parser(const std::string& text) : text_(text) {}

  Formula whole() {
    Formula formula = choice();
    blanks();
    if (at_ != text_.size()) fail();
    return formula;
  }

 private:
  [[noreturn]] void fail() const {
    throw ExpressionError(fmt::format("'{}' is no formula from its character {} on", text_, at_ + 1));
  }
  void blanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  bool take(std::string_view word) {
    blanks();
    if (text_.compare(at_, word.size(), word) != 0) return false;
    at_ += word.size();
    return true;
  }

  Formula choice() {
    if (++depth_ > deepest) fail();
    Formula condition = level(0);
    if (take("?")) {
      Formula yes = choice();
      if (!take(":")) fail();
      condition = call("?:", {std::move(condition), std::move(yes), choice()});
    }
    --depth_;
    return condition;
  }

  Formula level(std::size_t which) {
    if (which == levels.size()) return sign();
    Formula left = level(which + 1);
    for (;;) {
      const auto& words = levels[which];
      const auto found = std::find_if(words.begin(), words.end(), [&](std::string_view word) { return take(word); });
      if (found == words.end()) return left;
      left = call(std::string(*found), {std::move(left), level(which + 1)});
    }
  }

  Formula sign() {
    if (take("-")) return call("-", {sign()});
    if (take("+")) return sign();
    Formula base = atom();
    if (take("^")) return call("^", {std::move(base), sign()});
    return base;
  }

  Formula atom() {
    if (take("(")) {
      Formula inner = choice();
      if (!take(")")) fail();
      return inner;
    }
    blanks();
    if (at_ == text_.size()) fail();
    const char first = text_[at_];
    if ((first >= '0' && first <= '9') || first == '.') return digits();
    const auto end = std::min(
        text_.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_", at_), text_.size());
    if (end == at_) fail();
    const std::string word = text_.substr(at_, end - at_);
    at_ = end;
    return take("(") ? call(word, arguments()) : name(word);
  }

  std::vector<Formula> arguments() {
    std::vector<Formula> list;
    if (take(")")) return list;
    do list.push_back(choice());
    while (take(","));
    if (!take(")")) fail();
    return list;
  }

  Formula digits() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    return number(value);
  }

  const std::string& text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

// How strongly the outermost operator binds.
int strength(const Formula& formula) {
  if (formula.kind == Kind::number) return formula.value < 0 ? 4 : 9;
  if (formula.kind == Kind::name) return 9;
  if (formula.word == "?:") return -1;
  if (formula.word == "^") return 6;
  if (formula.of.size() == 1 && formula.word == "-") return 4;
  if (formula.of.size() != 2) return 9;
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (std::find(levels[k].begin(), levels[k].end(), formula.word) != levels[k].end()) return static_cast<int>(k);
  return 9;
}

std::string part(const Formula& formula, int least) {
  return strength(formula) < least ? "(" + write(formula) + ")" : write(formula);
}

}  // namespace

Formula number(double value) { return {Kind::number, value, "", {}}; }
Formula name(const std::string& word) { return {Kind::name, 0, word, {}}; }
Formula call(const std::string& word, std::vector<Formula> of) { return {Kind::call, 0, word, std::move(of)}; }

Formula parse_formula(const std::string& text) { return Parser(text).whole(); }

std::string write(const Formula& formula) {
  if (formula.kind == Kind::number) return fmt::format("{}", formula.value);
  if (formula.kind == Kind::name) return formula.word;
  const int own = strength(formula);
  const auto& of = formula.of;
  if (formula.word == "?:") return fmt::format("{} ? {} : {}", part(of[0], 0), part(of[1], 0), part(of[2], 0));
  if (own == 4 && of.size() == 1) return "-" + part(of[0], 5);
  if (own == 6) return fmt::format("{}^{}", part(of[0], 7), part(of[1], 7));
  if (own < 9) return fmt::format("{} {} {}", part(of[0], own), formula.word, part(of[1], own + 1));
  std::string list;
  for (const Formula& one : of) list += (list.empty() ? "" : ", ") + write(one);
  return fmt::format("{}({})", formula.word, list);
}

Formula replace(const Formula& formula, const std::map<std::string, Formula>& names) {
  if (formula.kind == Kind::name) {
    const auto found = names.find(formula.word);
    return found == names.end() ? formula : found->second;
  }
  Formula changed = formula;
  for (Formula& one : changed.of) one = replace(one, names);
  return changed;
}

bool reads(const Formula& formula, const std::string& name) {
  if (formula.kind == Kind::name) return formula.word == name;
  return std::any_of(formula.of.begin(), formula.of.end(), [&](const Formula& one) { return reads(one, name); });
}

}  // namespace shmoo::scene
