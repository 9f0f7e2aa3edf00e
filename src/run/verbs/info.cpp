// shmoo info OUT.h5: what is in a result.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "run/result_file.hpp"
#include "run/verbs/verbs.hpp"

namespace shmoo::run {
namespace {

std::string text_of(hid_t file, const std::string& object, const std::string& name) {
  return h5::get_text(h5::open(file, object), name);
}

void print_head(const ResultFile& result) {
  const hid_t file = result.id();
  const auto provenance = h5::open(file, "/provenance");
  fmt::print("{}\n", result.title.empty() ? "(no title)" : result.title);
  fmt::print("  status        {}{}{}\n", result.status, result.message.empty() ? "" : ": ", result.message);
  fmt::print("  realisations  {} of {}, seed {}\n", result.done, result.realisations, result.seed);
  fmt::print("  model         {} (SHA-256 {})\n", text_of(file, "/model", "file"), text_of(file, "/model", "sha256"));
  fmt::print("  build         shmoo {} {}, {}, -march {}\n", h5::get_text(provenance, "version"),
             h5::get_text(provenance, "revision"), h5::get_text(provenance, "compiler"),
             h5::get_text(provenance, "architecture").empty() ? "default" : h5::get_text(provenance, "architecture"));
  fmt::print("  made          {} on {}, {:.1f} s with {} threads\n", h5::get_text(provenance, "updated"),
             h5::get_text(provenance, "host"), h5::get_number(provenance, "seconds"),
             h5::get_number(provenance, "threads"));
  fmt::print("  CPU time      {:.3g} s a realisation, {:.3g} s for what all share\n",
             h5::get_number(provenance, "cpu_seconds_per_realisation"),
             h5::get_number(provenance, "cpu_seconds_shared"));
  if (result.dimension > 0)
    fmt::print("  particles     {} in {}-D, spacing {:.4g} m, materials {}\n", result.material.size(), result.dimension,
               result.spacing, fmt::join(result.material_names, ", "));
  if (!result.times.empty()) {
    fmt::print("  time          {} records from {:.6g} to {:.6g} s\n", result.times.size(), result.times.front(),
               result.times.back());
  }
}

void print_derived(hid_t file) {
  const auto names = h5::read_texts(file, "/derived/name"), units = h5::read_texts(file, "/derived/unit"),
             reasons = h5::read_texts(file, "/derived/why");
  const auto values = h5::read<double>(file, "/derived/value");
  if (!names.empty()) fmt::print("derived\n");
  for (std::size_t i = 0; i < names.size(); ++i)
    fmt::print("  {:<24} {:>12.6g} {:<10} {}\n", names[i], values[i], units[i], reasons[i]);
}

void print_fields(const ResultFile& result) {
  if (!result.fields.empty()) fmt::print("fields (last record: smallest .. largest mean)\n");
  for (const auto& field : result.fields) {
    auto mean = result.field_slice(field, result.times.size() - 1).mean;
    std::erase_if(mean, [](double value) { return std::isnan(value); });  // places that no particle has
    const auto [low, high] = std::minmax_element(mean.begin(), mean.end());
    fmt::print("  {:<24} {:>12.5g} .. {:<12.5g} {:<14} [{}]{}\n", field.name, mean.empty() ? 0 : *low,
               mean.empty() ? 0 : *high, field.unit, fmt::join(field.shape, ", "),
               field.varying ? "" : " the same in all realisations");
  }
}

void print_observables(const ResultFile& result) {
  if (!result.observables.empty()) fmt::print("observables (last record: mean +- standard error; deviation)\n");
  for (const auto& observable : result.observables) {
    const auto course = result.course(observable);
    if (observable.cells() != 1) {
      fmt::print("  {:<24} profile of {} values, {}\n", observable.name, observable.cells(), observable.unit);
      continue;
    }
    fmt::print("  {:<24} {:>12.6g}", observable.name, course.all.mean.back());
    if (!course.all.error.empty())
      fmt::print(" +- {:.2g}; {:.4g}", course.all.error.back(), course.all.deviation.back());
    fmt::print(" {}\n", observable.unit);
  }
}

void print_ledger(const ResultFile& result) {
  const hid_t file = result.id();
  const auto species = h5::children(file, "/ledger");
  if (species.empty()) return;
  fmt::print("ledger (molecules, sum over realisations)\n  {:<16} {:>16} {:>14} {:>14} {:>14} {:>14} {:>16}\n", "",
             "initial", "created", "destroyed", "entered", "left", "in the end");
  for (const auto& name : species) {
    const auto total = h5::read<double>(file, "/ledger/" + name + "/total");
    fmt::print("  {:<16} {:>16.10g} {:>14.10g} {:>14.10g} {:>14.10g} {:>14.10g} {:>16.10g}\n", name, total[0], total[1],
               total[2], total[3], total[4], total[0] + total[1] - total[2] + total[3] - total[4]);
  }
  const auto done = h5::read<std::uint8_t>(file, "/realisations/done"),
             balanced = h5::read<std::uint8_t>(file, "/realisations/balanced");
  std::vector<std::size_t> off;
  for (std::size_t k = 0; k < done.size(); ++k) {
    if (done[k] != 0 && balanced[k] == 0) off.push_back(k);
  }
  if (off.empty())
    fmt::print("  balanced in every finished realisation\n");
  else
    fmt::print("  NOT balanced in realisations {}\n", fmt::join(off, ", "));
}

}  // namespace

void declare_info(CLI::App& app, Desk&) {
  auto path = std::make_shared<std::string>();
  auto* verb = app.add_subcommand("info", "Say what is in a result file");
  verb->add_option("OUT.h5", *path, "a result of 'shmoo run'")->required();
  verb->callback([path] {
    const ResultFile result(*path);
    print_head(result);
    print_derived(result.id());
    print_fields(result);
    print_observables(result);
    print_ledger(result);
  });
}

}  // namespace shmoo::run
