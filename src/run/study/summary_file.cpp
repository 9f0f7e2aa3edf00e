// Summaries as TOML.
#include <fmt/format.h>
#include <toml++/toml.h>

#include "base/error.hpp"
#include "run/study/point_file.hpp"
#include "run/study/summary.hpp"
#include "run/study/toml_text.hpp"

namespace shmoo::run::study {
namespace {

template <class Owner, class Value>
struct Entry {
  const char* name;
  Value Owner::*value;
};

constexpr Entry<Summary, std::string> texts[] = {{"title", &Summary::title},       {"regime", &Summary::regime},
                                                 {"name", &Summary::name},         {"model", &Summary::model},
                                                 {"date", &Summary::date},         {"processor", &Summary::processor},
                                                 {"compiler", &Summary::compiler}, {"revisions", &Summary::revisions}};
constexpr Entry<Row, std::string> row_texts[] = {
    {"method", &Row::method}, {"level", &Row::level}, {"mean_of", &Row::mean_of}, {"failure", &Row::failure}};
constexpr Entry<Row, bool> row_flags[] = {{"random", &Row::random}, {"pareto", &Row::pareto}};
constexpr Entry<Row, std::size_t> row_counts[] = {{"repeats", &Row::repeats}, {"realisations", &Row::realisations}};
constexpr Entry<Row, double> row_numbers[] = {{"resolution", &Row::resolution},
                                              {"error", &Row::error},
                                              {"spread", &Row::spread},
                                              {"order", &Row::order},
                                              {"ours_in_published_norm", &Row::ours},
                                              {"published", &Row::published},
                                              {"cpu_seconds", &Row::cpu_seconds},
                                              {"cpu_seconds_per_realisation", &Row::cpu_per_realisation},
                                              {"steps", &Row::steps},
                                              {"events", &Row::events},
                                              {"memory_bytes", &Row::memory},
                                              {"statistical_error_predicted", &Row::predicted},
                                              {"statistical_error_measured", &Row::measured},
                                              {"bias", &Row::bias},
                                              {"bias_seen_from", &Row::bias_seen_from},
                                              {"systematic_error_seen_from", &Row::systematic_seen_from},
                                              {"systematic_error", &Row::systematic}};

std::string row_text(const Row& row) {
  std::string text = "\n[[quantity.row]]\n";
  for (const auto& [name, value] : row_texts)
    if (!(row.*value).empty()) text += fmt::format("{} = {}\n", name, toml_text(row.*value));
  for (const auto& [name, value] : row_flags) text += fmt::format("{} = {}\n", name, row.*value);
  for (const auto& [name, value] : row_counts) text += fmt::format("{} = {}\n", name, row.*value);
  for (const auto& [name, value] : row_numbers)
    if (row.*value == row.*value) text += fmt::format("{} = {}\n", name, toml_text(row.*value));
  return text;
}

Row row_in(const toml::table& table) {
  Row row;
  for (const auto& [name, value] : row_texts) row.*value = table[name].value_or(std::string());
  for (const auto& [name, value] : row_flags) row.*value = table[name].value_or(false);
  for (const auto& [name, value] : row_counts) row.*value = table[name].value_or(std::size_t{1});
  for (const auto& [name, value] : row_numbers) row.*value = table[name].value_or(unknown);
  return row;
}

std::string need_text(const Need& need) {
  return fmt::format(
      "\n[[quantity.need]]\nwanted = {}\nmethod = {}\nlevel = {}\nrealisations = {}\ncpu_seconds = {}\nrandom = {}\n",
      toml_text(need.wanted), toml_text(need.method), toml_text(need.level), need.realisations,
      toml_text(need.cpu_seconds), need.random);
}

Need need_in(const toml::table& table) {
  return {table["wanted"].value_or(0.0),
          table["cpu_seconds"].value_or(unknown),
          table["method"].value_or(std::string()),
          table["level"].value_or(std::string()),
          table["realisations"].value_or(std::size_t{1}),
          table["random"].value_or(false)};
}

template <class Take>
void each_table(const toml::table& holder, const char* name, Take take) {
  if (const auto* list = holder.get_as<toml::array>(name))
    for (const auto& entry : *list)
      if (const auto* table = entry.as_table()) take(*table);
}

Verdict verdict_in(const toml::table& table) {
  Verdict verdict{.quantity = table["name"].value_or(std::string()), .norm = table["norm"].value_or(std::string())};
  each_table(table, "row", [&](const auto& row) { verdict.rows.push_back(row_in(row)); });
  each_table(table, "need", [&](const auto& need) { verdict.needs.push_back(need_in(need)); });
  return verdict;
}

}  // namespace

void write_summary(const std::filesystem::path& path, const Summary& summary) {
  std::string text = "# Written by 'shmoo study'. SI units; errors in the norm and scale of the quantity.\n";
  for (const auto& [name, value] : texts) text += fmt::format("{} = {}\n", name, toml_text(summary.*value));
  text += fmt::format("cores = {}\nruns = {}\nfailed = {}\ncpu_seconds = {}\n", summary.cores, summary.runs,
                      summary.failed, toml_text(summary.cpu_seconds));
  for (const auto& verdict : summary.verdicts) {
    text += fmt::format("\n[[quantity]]\nname = {}\nnorm = {}\n", toml_text(verdict.quantity), toml_text(verdict.norm));
    for (const auto& row : verdict.rows) text += row_text(row);
    for (const auto& need : verdict.needs) text += need_text(need);
  }
  write_whole(path, text);
}

Summary read_summary(const std::filesystem::path& path) {
  toml::table root;
  try {
    root = toml::parse_file(path.string());
  } catch (const toml::parse_error& error) {
    throw base::InputError(fmt::format("{} is no summary of a study: {}", path.string(), error.description()));
  }
  if (!root.contains("quantity") || !root.contains("runs"))
    throw base::InputError(fmt::format("{} is no summary of a study: it holds no quantities", path.string()));
  Summary summary;
  for (const auto& [name, value] : texts) summary.*value = root[name].value_or(std::string());
  summary.cores = root["cores"].value_or(std::size_t{1});
  summary.runs = root["runs"].value_or(std::size_t{0});
  summary.failed = root["failed"].value_or(std::size_t{0});
  summary.cpu_seconds = root["cpu_seconds"].value_or(unknown);
  each_table(root, "quantity", [&](const auto& quantity) { summary.verdicts.push_back(verdict_in(quantity)); });
  return summary;
}

}  // namespace shmoo::run::study
