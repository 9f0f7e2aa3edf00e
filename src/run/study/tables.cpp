#include "run/study/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shmoo::run::study {
namespace {

std::string number(double value, const char* format) {
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "";
}
std::string error_text(double value) { return number(value, "{:.2e}"); }
std::string count_text(double value) {
  return !std::isfinite(value) ? "" : value < 1e6 ? fmt::format("{:.0f}", value) : fmt::format("{:.2e}", value);
}
std::string seconds_text(double value) { return number(value, value < 10 ? "{:.2g}" : "{:.0f}"); }

// "< LIMIT" where chance would hide it.
std::string beyond_chance(double value, double limit) {
  return value < limit ? "< " + error_text(limit) : error_text(value);
}

// Bytes of UTF-8 that begin a character.
std::size_t width(const std::string& text) {
  return std::size_t(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; }));
}

using Cells = std::vector<std::string>;

std::string markdown(const Cells& head, const std::vector<Cells>& rows) {
  if (rows.empty()) return "";
  std::string text;
  std::vector<std::size_t> widths(head.size(), 0);
  for (std::size_t c = 0; c < head.size(); ++c)
    for (const auto& row : rows)
      if (!row[c].empty()) widths[c] = std::max({widths[c], width(head[c]), width(row[c])});
  const auto line = [&](const Cells& cells, bool rule) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (widths[c] == 0) continue;
      const auto& cell = cells[c].empty() ? std::string("-") : cells[c];
      text += rule ? fmt::format("| {} ", std::string(widths[c], '-'))
                   : fmt::format("| {}{} ", cell, std::string(widths[c] - width(cell), ' '));
    }
    text += "|\n";
  };
  line(head, false);
  line(head, true);
  for (const auto& row : rows) line(row, false);
  return text;
}

}  // namespace

std::string errors_table(const Verdict& verdict) {
  std::vector<Cells> rows;
  for (const auto& row : verdict.rows) {
    const bool failed = !std::isfinite(row.error);
    rows.push_back({row.method, row.level, row.random ? std::to_string(row.realisations) : "",
                    failed ? "failed" : error_text(row.error) + (row.pareto ? " *" : ""), error_text(row.spread),
                    number(row.order, "{:.2f}"), std::isfinite(row.published) ? error_text(row.ours) : "",
                    error_text(row.published), seconds_text(row.cpu_seconds), count_text(row.steps),
                    row.events > 0 ? count_text(row.events) : "", number(row.memory / 1048576.0, "{:.0f}")});
  }
  return markdown({"method", "level", "realisations", "error", "±", "order", "as published", "published", "CPU s",
                   "steps", "events", "MiB"},
                  rows);
}

std::string statistics_table(const Verdict& verdict) {
  std::vector<Cells> rows;
  for (const auto& row : verdict.rows) {
    if (!row.random || !(std::isfinite(row.predicted) || std::isfinite(row.measured))) continue;
    rows.push_back({row.method, row.level, fmt::format("{} x {}", row.repeats, row.realisations),
                    error_text(row.predicted), error_text(row.measured), number(row.measured / row.predicted, "{:.3f}"),
                    beyond_chance(row.bias, row.bias_seen_from), row.mean_of,
                    beyond_chance(row.systematic, row.systematic_seen_from), seconds_text(row.cpu_per_realisation)});
  }
  return markdown({"method", "level", "repeats x realisations", "chance, predicted", "chance, measured", "ratio",
                   "bias of the mean", "against", "left without chance", "CPU s each"},
                  rows);
}

std::string needs_table(const Verdict& verdict) {
  std::vector<Cells> rows;
  for (const auto& need : verdict.needs) {
    rows.push_back({error_text(need.wanted), need.method, need.level,
                    need.random ? std::to_string(need.realisations) : "", seconds_text(need.cpu_seconds)});
  }
  return markdown({"error wanted", "method", "level", "realisations needed", "CPU s"}, rows);
}

std::string failures_text(const Verdict& verdict) {
  std::string text;
  for (const auto& row : verdict.rows)
    if (!row.failure.empty()) text += fmt::format("* {} at {} failed: {}\n", row.method, row.level, row.failure);
  return text;
}

double measured_over_predicted(const Verdict& verdict) {
  double sum = 0.0, rows = 0.0;
  for (const auto& row : verdict.rows) {
    const double ratio = row.measured / row.predicted;
    if (std::isfinite(ratio)) sum += ratio * ratio, rows += 1.0;
  }
  return rows > 0.0 ? std::sqrt(sum / rows) : unknown;
}

}  // namespace shmoo::run::study
