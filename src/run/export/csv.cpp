// Comma-separated tables with one header line; numbers with all their digits.
#include <fmt/format.h>
#include <fmt/os.h>

#include <array>
#include <cmath>

#include "base/error.hpp"
#include "run/export/export.hpp"

namespace shmoo::run {
namespace {

constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};

std::string unit_in_brackets(const std::string& unit) { return unit.empty() ? "" : fmt::format(" [{}]", unit); }

// Names such as "q0.05" are what statistics are called in every table.
std::string statistics_header(const Entry& entry, bool varies) {
  const auto unit = unit_in_brackets(entry.unit);
  if (!varies) return fmt::format("{}{}", entry.name, unit);
  auto header = fmt::format("mean{0},deviation{0},standard_error{0}", unit);
  for (const auto q : entry.probabilities) header += fmt::format(",q{:g}{}", q, unit);
  return header;
}

std::string statistics_row(const Slice& slice, std::size_t at) {
  auto row = fmt::format("{:.17g}", slice.mean[at]);
  if (slice.deviation.empty()) return row;
  row += fmt::format(",{:.17g},{:.17g}", slice.deviation[at], slice.error[at]);
  for (const auto& quantile : slice.quantiles) row += fmt::format(",{:.17g}", quantile[at]);
  return row;
}

// Characters that no file name should have become underscores.
std::string safe(std::string name) {
  for (auto& c : name) {
    if (c == '/' || c == '\\' || c == ' ' || c == '"' || c == ':') c = '_';
  }
  return name;
}

void write_field(const ResultFile& result, const Entry& field, const std::filesystem::path& path) {
  auto out = fmt::output_file(path.string());
  const auto components = field.shape.size() > 1 ? field.shape[1] : 1;
  const bool varies = field.varying && result.done > 1;
  out.print("time [s],particle,material");
  for (int a = 0; a < result.dimension; ++a) out.print(",{} [m]", axis_names[static_cast<std::size_t>(a)]);
  out.print("{},{}\n", components > 1 ? ",component" : "", statistics_header(field, varies));
  for (std::size_t t = 0; t < result.times.size(); ++t) {
    const auto positions = result.positions(t);
    const auto slice = result.field_slice(field, t);
    for (std::size_t i = 0; i < slice.mean.size(); ++i) {
      const auto particle = i / components;
      if (std::isnan(positions[3 * particle])) continue;  // nothing is there now
      const auto material = static_cast<std::size_t>(result.material[particle]);
      out.print("{:.17g},{},{}", result.times[t], particle, result.material_names[material]);
      for (int a = 0; a < result.dimension; ++a)
        out.print(",{:.17g}", positions[3 * particle + static_cast<std::size_t>(a)]);
      if (components > 1) out.print(",{}", axis_names.at(i % components));
      out.print(",{}\n", statistics_row(slice, i));
    }
  }
}

void write_observable(const ResultFile& result, const Entry& observable, const std::filesystem::path& path) {
  auto out = fmt::output_file(path.string());
  const auto course = result.course(observable);
  const auto bins = observable.cells();
  const bool profile = !observable.shape.empty();
  out.print("time [s]{},{}", profile ? ",bin,axis [m]" : "",
            statistics_header(observable, !course.all.deviation.empty()));
  for (std::size_t k = 0; k < course.realisations; ++k)
    out.print(",realisation_{}{}", k, unit_in_brackets(observable.unit));
  out.print("\n");
  for (std::size_t at = 0; at < course.all.mean.size(); ++at) {
    const auto bin = at % bins;
    out.print("{:.17g}", result.times[at / bins]);
    if (profile && bin < observable.axis.size())
      out.print(",{},{:.17g}", bin, observable.axis[bin]);
    else if (profile)
      out.print(",{},", bin);
    out.print(",{}", statistics_row(course.all, at));
    for (std::size_t k = 0; k < course.realisations; ++k)
      out.print(",{:.17g}", course.values[k * course.all.mean.size() + at]);
    out.print("\n");
  }
}

}  // namespace

std::vector<std::filesystem::path> export_csv(const ResultFile& result, const std::filesystem::path& folder) {
  make_folder(folder);
  std::vector<std::filesystem::path> written;
  try {
    for (const auto& field : result.fields) {
      if (field.shape.empty() || field.shape[0] != result.material.size()) continue;
      written.push_back(folder / fmt::format("field_{}.csv", safe(field.name)));
      write_field(result, field, written.back());
    }
    for (const auto& observable : result.observables) {
      written.push_back(folder / fmt::format("observable_{}.csv", safe(observable.name)));
      write_observable(result, observable, written.back());
    }
  } catch (const std::system_error& error) {
    throw base::RunError(fmt::format("cannot write {}: {}", written.back().string(), error.what()));
  }
  return written;
}

}  // namespace shmoo::run
