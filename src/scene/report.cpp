#include "scene/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <tuple>

#include "base/nearest.hpp"

namespace shmoo::scene {
namespace {

constexpr std::size_t most_diagnostics = 100;  // shown
constexpr std::size_t most_collected = 1000;   // a file with more is given up at once
constexpr std::size_t longest_list = 30;       // names
constexpr std::size_t longest_name = 64;       // bytes that are compared with valid names
constexpr std::size_t longest_quote = 60;      // bytes

auto order(const base::Diagnostic& diagnostic) {
  const auto& [file, line, column] = diagnostic.where;
  return std::tuple(line == 0, line, column);  // those of the command line last
}

}  // namespace

base::Location Report::location(const toml::source_region& at) const {
  if (at.path && at.path->starts_with("--set")) return {*at.path, 0, 0};
  return {file_, static_cast<int>(at.begin.line), static_cast<int>(at.begin.column)};
}

void Report::add(const toml::node& at, std::string message) {
  mark_bad(at);
  add(at.source(), std::move(message));
}

void Report::add(const toml::source_region& at, std::string message) {
  diagnostics_.push_back({location(at), std::move(message)});
  if (diagnostics_.size() >= most_collected) finish();
}

void Report::finish() {
  if (diagnostics_.empty()) return;
  std::stable_sort(diagnostics_.begin(), diagnostics_.end(),
                   [](const auto& a, const auto& b) { return order(a) < order(b); });
  if (diagnostics_.size() > most_diagnostics) {
    const auto more = diagnostics_.size() - most_diagnostics;
    diagnostics_.resize(most_diagnostics);
    diagnostics_.push_back({{file_, 0, 0},
                            fmt::format("{} more mistakes are not shown", more == most_collected - most_diagnostics
                                                                              ? fmt::format("{} or", more)
                                                                              : fmt::format("{}", more))});
  }
  throw base::InputError(std::move(diagnostics_));
}

std::string suggestion(std::string_view given, const std::vector<std::string>& names, std::string rest) {
  const std::string meant = base::did_you_mean(given.substr(0, longest_name), names);
  if (meant.empty()) return fmt::format("; {}", rest);
  rest.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(rest.front())));
  return fmt::format("{} {}", meant, rest);
}

std::string listed(const std::vector<std::string>& names) {
  if (names.size() <= longest_list) return base::list_of(names);
  return fmt::format("{}, ... ({} in all)", base::list_of(std::span(names).first(longest_list)), names.size());
}

std::string quoted(std::string_view text) {
  std::string shown;
  bool cut = false;
  for (const char character : text) {
    // A cut must not fall inside a UTF-8 character.
    if (shown.size() >= longest_quote && (static_cast<unsigned char>(character) & 0xc0) != 0x80) {
      cut = true;
      break;
    }
    const bool control = static_cast<unsigned char>(character) < 0x20 || character == 0x7f;
    shown += control ? ' ' : character;
  }
  return fmt::format("\"{}{}\"", shown, cut ? "..." : "");
}

}  // namespace shmoo::scene
