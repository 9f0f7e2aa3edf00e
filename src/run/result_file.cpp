#include "run/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/nearest.hpp"

namespace shmoo::run {
namespace {

h5::Handle open_result(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw base::InputError(fmt::format("{} does not exist; a result file of 'shmoo run' is needed", path.string()));
  try {
    auto file = h5::open_for_reading(path);
    if (h5::has(file, "format") && h5::get_text(file, "format") == "shmoo result") return file;
  } catch (const base::RunError& error) {
    throw base::InputError(fmt::format("{} is no result file: {}", path.string(), error.what()));
  }
  throw base::InputError(fmt::format("{} is an HDF5 file, but no result of 'shmoo run'", path.string()));
}

std::vector<std::size_t> shape_after_time(const h5::Dims& dims) { return {dims.begin() + 1, dims.end()}; }

std::vector<double> row(hid_t file, const std::string& path, std::size_t time, std::size_t leading = 0,
                        bool has_leading = false) {
  auto count = h5::dims(file, path);
  h5::Dims start(count.size(), 0);
  if (has_leading) start[0] = leading, count[0] = 1;
  start[has_leading ? 1 : 0] = time, count[has_leading ? 1 : 0] = 1;
  return h5::read_block<double>(file, path, start, count);
}

std::vector<double> roots(std::vector<double> values) {
  for (auto& value : values) value = std::sqrt(value);
  return values;
}

const Entry& find(const std::vector<Entry>& entries, const std::string& name, const char* kind,
                  const std::filesystem::path& path) {
  std::vector<std::string> names;
  for (const auto& entry : entries) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw base::InputError(fmt::format("{} has no {} '{}'{}; it has: {}", path.string(), kind, name,
                                     base::did_you_mean(name, names), base::list_of(names)));
}

}  // namespace

std::size_t Entry::cells() const {
  std::size_t product = 1;
  for (const auto extent : shape) product *= extent;
  return product;
}

ResultFile::ResultFile(const std::filesystem::path& path) : path_(path), file_(open_result(path)) {
  status = h5::get_text(file_, "status");
  message = h5::get_text(file_, "message");
  seed = h5::get_whole(file_, "seed");
  realisations = h5::get_whole(file_, "realisations");
  done = h5::get_whole(file_, "realisations_done");
  const auto model = h5::open(file_, "/model");
  title = h5::get_text(model, "title");
  dimension = static_cast<int>(h5::get_number(model, "dimension"));
  axisymmetric = h5::has(model, "axisymmetric");
  spacing = h5::get_number(model, "spacing");
  depth = h5::get_number(model, "depth");
  lower = h5::get_numbers(model, "lower");
  upper = h5::get_numbers(model, "upper");
  times = h5::read<double>(file_, "/time");
  material = h5::read<std::int32_t>(file_, "/particles/material");
  material_names = h5::read_texts(file_, "/particles/material_names");
  material_types = h5::read_texts(file_, "/particles/material_types");
  for (const auto& name : h5::children(file_, "/fields")) fields.push_back(describe_field(name));
  for (const auto& name : h5::children(file_, "/observables")) observables.push_back(describe_observable(name));
}

Entry ResultFile::describe_field(const std::string& name) const {
  const auto at = "/fields/" + name;
  const auto object = h5::open(file_, at);
  Entry entry{.name = name, .unit = h5::get_text(object, "unit"), .varying = H5Iget_type(object) == H5I_GROUP};
  if (h5::has(object, "materials")) entry.materials = h5::get_texts(object, "materials");
  entry.shape = shape_after_time(h5::dims(file_, entry.varying ? at + "/mean" : at));
  if (entry.varying) entry.probabilities = h5::get_numbers(h5::open(file_, at + "/quantiles"), "probabilities");
  return entry;
}

Entry ResultFile::describe_observable(const std::string& name) const {
  const auto at = "/observables/" + name;
  const auto object = h5::open(file_, at);
  Entry entry{.name = name, .unit = h5::get_text(object, "unit"), .varying = h5::get_number(object, "shared") == 0.0};
  entry.shape = shape_after_time(h5::dims(file_, at + "/mean"));
  entry.probabilities = h5::get_numbers(h5::open(file_, at + "/quantiles"), "probabilities");
  if (h5::exists(file_, at + "/axis")) entry.axis = h5::read<double>(file_, at + "/axis");
  return entry;
}

const Entry& ResultFile::field(const std::string& name) const { return find(fields, name, "field", path_); }
const Entry& ResultFile::observable(const std::string& name) const {
  return find(observables, name, "observable", path_);
}

std::vector<double> ResultFile::positions(std::size_t time) const {
  const auto recorded = std::find_if(fields.begin(), fields.end(), [](const auto& f) { return f.name == "position"; });
  if (recorded == fields.end()) return h5::read<double>(file_, "/particles/start_position");
  const auto flat = field_slice(*recorded, time).mean;
  if (recorded->shape.back() == 3) return flat;
  const auto d = recorded->shape.back();
  std::vector<double> padded(flat.size() / d * 3, 0.0);
  for (std::size_t i = 0; i < flat.size(); ++i) padded[i / d * 3 + i % d] = flat[i];
  return padded;
}

Slice ResultFile::field_slice(const Entry& entry, std::size_t time) const {
  const auto at = "/fields/" + entry.name;
  if (!entry.varying) return {row(file_, at, time), {}, {}, {}};
  Slice slice;
  slice.mean = row(file_, at + "/mean", time);
  if (done < 2) return slice;
  slice.deviation = roots(row(file_, at + "/variance", time));
  slice.error = slice.deviation;
  for (auto& error : slice.error) error /= std::sqrt(static_cast<double>(done));
  for (std::size_t q = 0; q < entry.probabilities.size(); ++q)
    slice.quantiles.push_back(row(file_, at + "/quantiles", time, q, true));
  return slice;
}

Course ResultFile::course(const Entry& entry) const {
  const auto at = "/observables/" + entry.name;
  Course course;
  course.all.mean = h5::read<double>(file_, at + "/mean");
  if (!entry.varying) return course;
  const auto flags = h5::read<std::uint8_t>(file_, "/realisations/done");
  const auto values = h5::read<double>(file_, at + "/values");
  const auto size = times.size() * entry.cells();
  for (std::size_t k = 0; k < flags.size(); ++k) {
    if (flags[k] == 0) continue;
    const auto from = values.begin() + static_cast<std::ptrdiff_t>(k * size);
    course.values.insert(course.values.end(), from, from + static_cast<std::ptrdiff_t>(size));
    ++course.realisations;
  }
  if (done < 2) return course;
  course.all.deviation = roots(h5::read<double>(file_, at + "/variance"));
  course.all.error = h5::read<double>(file_, at + "/standard_error");
  const auto quantiles = h5::read<double>(file_, at + "/quantiles");
  for (std::size_t q = 0; q < entry.probabilities.size(); ++q) {
    const auto from = quantiles.begin() + static_cast<std::ptrdiff_t>(q * size);
    course.all.quantiles.emplace_back(from, from + static_cast<std::ptrdiff_t>(size));
  }
  return course;
}

std::size_t ResultFile::nearest_time(double t) const {
  const auto closer = [&](double a, double b) { return std::abs(a - t) < std::abs(b - t); };
  return static_cast<std::size_t>(std::min_element(times.begin(), times.end(), closer) - times.begin());
}

}  // namespace shmoo::run
