#include "run/page/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "run/page/html.hpp"
#include "run/plot/gallery.hpp"
#include "run/scratch_folder.hpp"

namespace shmoo::run {
namespace {

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string section(const std::string& heading, const std::string& body) {
  return body.empty() ? "" : fmt::format("<h2>{}</h2>\n{}", html::escaped(heading), body);
}

std::string provenance(const ResultFile& result) {
  const auto made = h5::open(result.id(), "/provenance"), model = h5::open(result.id(), "/model");
  const auto text = [&](const h5::Handle& from, const char* name) { return h5::get_text(from, name); };
  std::vector<html::Row> rows{
      {"status", result.status + (result.message.empty() ? "" : ": " + result.message)},
      {"realisations", fmt::format("{} of {}, seed {}", result.done, result.realisations, result.seed)},
      {"model", fmt::format("{} (SHA-256 {})", text(model, "file"), text(model, "sha256"))},
      {"command", text(made, "command")},
      {"program", fmt::format("shmoo {} {}, {}, {}", text(made, "version"), text(made, "revision"),
                              text(made, "compiler"), text(made, "flags"))},
      {"made", fmt::format("{} on {}", text(made, "updated"), text(made, "host"))},
      {"CPU time",
       fmt::format("{:.3g} s a realisation, {:.3g} s for what all share",
                   h5::get_number(made, "cpu_seconds_per_realisation"), h5::get_number(made, "cpu_seconds_shared"))}};
  if (result.dimension > 0)
    rows.push_back(
        {"particles", fmt::format("{} in {}-D, spacing {:.4g} m, materials {}", result.material.size(),
                                  result.dimension, result.spacing, fmt::join(result.material_names, ", "))});
  rows.push_back({"time", fmt::format("{} records from {:.6g} to {:.6g} s", result.times.size(), result.times.front(),
                                      result.times.back())});
  return html::table({}, rows, false);
}

std::string derived(const ResultFile& result) {
  const hid_t file = result.id();
  const auto names = h5::read_texts(file, "/derived/name"), units = h5::read_texts(file, "/derived/unit"),
             reasons = h5::read_texts(file, "/derived/why");
  const auto values = h5::read<double>(file, "/derived/value");
  std::vector<html::Row> rows;
  for (std::size_t i = 0; i < names.size(); ++i) rows.push_back({names[i], number(values[i]), units[i], reasons[i]});
  return rows.empty() ? "" : html::table({"number", "value", "unit", "why"}, rows, false);
}

std::string observables(const ResultFile& result) {
  std::vector<html::Row> rows;
  for (const auto& observable : result.observables) {
    if (observable.cells() != 1) continue;
    const auto last = result.course(observable).all;
    const bool spread = !last.error.empty();
    rows.push_back({observable.name, number(last.mean.back()), spread ? fmt::format("{:.2g}", last.error.back()) : "-",
                    spread ? number(last.deviation.back()) : "-", observable.unit});
  }
  return rows.empty() ? ""
                      : html::table({"at the last record", "mean", "standard error", "deviation", "unit"}, rows, true);
}

std::string ledger(const ResultFile& result) {
  const auto species = h5::children(result.id(), "/ledger");
  if (species.empty()) return "";
  std::vector<html::Row> rows;
  for (const auto& name : species) {
    auto total = h5::read<double>(result.id(), "/ledger/" + name + "/total");
    total.push_back(total[0] + total[1] - total[2] + total[3] - total[4]);
    html::Row row{name};
    for (const double amount : total) row.push_back(fmt::format("{:.10g}", amount));
    rows.push_back(row);
  }
  const auto done = h5::read<std::uint8_t>(result.id(), "/realisations/done"),
             balanced = h5::read<std::uint8_t>(result.id(), "/realisations/balanced");
  bool right = true;
  for (std::size_t k = 0; k < done.size(); ++k) right = right && (done[k] == 0 || balanced[k] != 0);
  return html::table({"molecules", "initial", "created", "destroyed", "entered", "left", "in the end"}, rows, true) +
         (right ? "<p>Balanced in every finished realisation.</p>\n"
                : "<p class=\"warning\">Not balanced in every realisation.</p>\n");
}

std::string pictures(const ResultFile& result, std::size_t time) {
  const ScratchFolder folder("shmoo-report");
  std::string body;
  for (const auto& picture : gallery(result, {.times = {time}})) {
    const auto png = folder.path() / picture.name;
    picture.draw(png);
    body += html::image(png, picture.of);
  }
  return body;
}

}  // namespace

std::string result_page(const ResultFile& result, std::size_t time) {
  std::string body = provenance(result);
  body += section("Observables", observables(result));
  body += section(fmt::format("Pictures at {:.6g} s", result.times[time]), pictures(result, time));
  body += section("Where the molecules went", ledger(result));
  body += section("Derived numbers", derived(result));
  body += section("The model", "<pre>" + html::escaped(h5::read_text(result.id(), "/model/text")) + "</pre>\n");
  return html::document(result.title.empty() ? result.path().filename().string() : result.title, body);
}

}  // namespace shmoo::run
