#include "run/study/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "run/study/tables.hpp"

namespace shmoo::run::study {
namespace {

std::string verdict_text(const Verdict& verdict) {
  std::string text = errors_table(verdict);
  const auto section = [&](const char* head, const std::string& table) {
    if (!table.empty()) text += fmt::format("\n{}\n\n{}", head, table);
  };
  section("Error of the mean, apart (root mean square):", statistics_table(verdict));
  if (const double ratio = measured_over_predicted(verdict); std::isfinite(ratio))
    text += fmt::format("\nChance measured over predicted, all rows: {:.3f}\n", ratio);
  section("What an accuracy costs:", needs_table(verdict));
  section("Failed:", failures_text(verdict));
  return text;
}

// The cheapest way to an accuracy, of all methods or of random ones only; null where there is none.
const Need* cheapest(const Verdict& verdict, double wanted, bool random_only) {
  const Need* best = nullptr;
  for (const auto& need : verdict.needs)
    if (need.wanted == wanted && (need.random || !random_only) && (!best || need.cpu_seconds < best->cpu_seconds))
      best = &need;
  return best;
}

std::string choice(const Need* need) {
  if (!need) return "-";
  const auto realisations =
      need->random ? fmt::format(", {} realisation{}", need->realisations, need->realisations == 1 ? "" : "s") : "";
  return fmt::format("{} at {}{}: {:.2g} CPU s", need->method, need->level, realisations, need->cpu_seconds);
}

std::string choice_rows(const Summary& summary, const Verdict& verdict) {
  std::string text;
  double told = 0.0;
  for (const auto& need : verdict.needs) {
    if (need.wanted == told) continue;
    told = need.wanted;
    text += fmt::format("| {} | {} | {:.0e} | {} | {} |\n", summary.regime, verdict.quantity, told,
                        choice(cheapest(verdict, told, false)), choice(cheapest(verdict, told, true)));
  }
  return text;
}

std::string study_text(const Summary& summary, const std::filesystem::path& folder, const std::filesystem::path& page) {
  std::string text =
      fmt::format("\n## {}\n\n{}. `{}`; {} runs, {} failed, {:.0f} CPU s; {}, {} cores, {}, {}; revision {}.\n",
                  summary.title, summary.regime, summary.model, summary.runs, summary.failed, summary.cpu_seconds,
                  summary.processor, summary.cores, summary.compiler, summary.date, summary.revisions);
  for (const auto& verdict : summary.verdicts) {
    text += fmt::format("\n### {}\n\nError: {}.\n\n{}", verdict.quantity, verdict.norm, verdict_text(verdict));
    const auto png = folder / fmt::format("{}-{}.png", summary.name, verdict.quantity);
    if (std::filesystem::exists(png))
      text +=
          fmt::format("\n![error against CPU time]({})\n", png.lexically_relative(page.parent_path()).generic_string());
  }
  return text;
}

constexpr const char* head =
    "# Accuracy and what it costs\n\n"
    "Written by `tools/accuracy`, which runs every study of the shipped models; do not edit. CPU seconds are those of "
    "the whole process, one thread, with reading, writing and statistics. An asterisk marks the Pareto front: no other "
    "row is both cheaper and more accurate. \"±\" is the standard deviation between ensembles with seeds of their own. "
    "\"As published\" is our error in the norm of the published one beside it. The error of an ensemble's mean has a "
    "part that is chance and falls with the square root of the number of realisations, and a part that does not: "
    "\"chance, predicted\" is sqrt(variance/N) from within one ensemble, \"chance, measured\" the scatter between "
    "ensembles, \"bias\" what the mean is off from the method that it should agree with (\"<\": less than chance "
    "hides), \"left without chance\" the error that no number of realisations removes.\n";

}  // namespace

std::string printed(const Summary& summary) {
  std::string text = fmt::format("{}\n", summary.title);
  for (const auto& verdict : summary.verdicts)
    text += fmt::format("\n{} (error: {}; * on the Pareto front)\n\n{}", verdict.quantity, verdict.norm,
                        verdict_text(verdict));
  return text + fmt::format("\n{} runs, {} failed, {:.1f} CPU s\n", summary.runs, summary.failed, summary.cpu_seconds);
}

std::string report(const std::filesystem::path& folder, const std::filesystem::path& page) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  if (files.empty())
    throw base::InputError(
        fmt::format("{} holds no summary of a study (*.toml); make some with 'shmoo study STUDY -o {}'",
                    folder.string(), folder.string()));
  std::sort(files.begin(), files.end());
  std::string choices, studies;
  for (const auto& file : files) {
    const auto summary = read_summary(file);
    for (const auto& verdict : summary.verdicts) choices += choice_rows(summary, verdict);
    studies += study_text(summary, folder, page);
  }
  return fmt::format(
      "{}\n## Which method for which accuracy\n\nThe cheapest of all, and the cheapest that draws single molecules or "
      "thermal kicks (where spreads are wanted besides means).\n\n| problem | quantity | error wanted | cheapest | "
      "cheapest random method |\n| --- | --- | --- | --- | --- |\n{}{}",
      head, choices, studies);
}

}  // namespace shmoo::run::study
