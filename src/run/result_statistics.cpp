// /fields and /observables.
#include <algorithm>
#include <cmath>
#include <limits>

#include "run/hdf5.hpp"
#include "run/result_write.hpp"

namespace shmoo::run {
namespace {

using coupling::FieldInfo;

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

h5::Dims shape_of(const FieldInfo& info, std::size_t times) {
  h5::Dims dims{times};
  dims.insert(dims.end(), info.shape.begin(), info.shape.end());
  return dims;
}

h5::Dims with_leading(std::size_t first, const h5::Dims& dims) {
  h5::Dims out{first};
  out.insert(out.end(), dims.begin(), dims.end());
  return out;
}

// The unit of squares of `unit`.
std::string squared(const std::string& unit) { return unit.empty() || unit == "1" ? unit : "(" + unit + ")^2"; }

// Where a field has values: the homes of the species of its name; everywhere else.
void set_homes(hid_t object, const FieldInfo& info, const scene::Scene& scene) {
  const auto& all = scene.species;
  const auto species = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == info.name; });
  if (species == all.end()) return;
  h5::Strings homes;
  for (const auto home : species->homes) homes.push_back(scene.materials[static_cast<std::size_t>(home)].name);
  h5::set(object, "materials", homes);
}

void write_shared_field(hid_t file, const FieldInfo& info, const scene::Scene& scene, std::size_t times,
                        const std::vector<double>& data) {
  // Before the shared part is computed there is nothing to show.
  const auto dims = shape_of(info, times);
  const auto name = "/fields/" + info.name;
  const auto dataset =
      data.empty() ? h5::make_dataset<double>(file, name, dims) : h5::write<double>(file, name, dims, data);
  h5::set(dataset, "unit", info.unit);
  set_homes(dataset, info, scene);
}

// One time after the other, so that memory holds one slice of each dataset only.
void write_slices(hid_t mean, hid_t variance, hid_t quantiles, const FieldInfo& info, const std::vector<Block>& blocks,
                  const std::vector<double>& probabilities) {
  const double quantum = info.whole ? 1.0 : base::FixedPoint(info.scale).quantum();
  const auto size = cells(info);
  auto count = shape_of(info, 1);
  std::vector<double> slice(size);
  for (std::size_t t = 0; t < blocks.size(); ++t) {
    const auto& [sums, histograms] = blocks[t];
    h5::Dims start(count.size(), 0);
    start[0] = t;
    for (std::size_t c = 0; c < size; ++c) slice[c] = sums.mean(c) * quantum;
    h5::write_block<double>(mean, start, count, slice);
    for (std::size_t c = 0; c < size; ++c) slice[c] = sums.variance(c) * quantum * quantum;
    h5::write_block<double>(variance, start, count, slice);
    for (std::size_t q = 0; q < probabilities.size(); ++q) {
      for (std::size_t c = 0; c < size; ++c) {
        slice[c] = histograms.samples() == 0 ? no_number : histograms.quantile(c, probabilities[q]) * quantum;
      }
      h5::write_block<double>(quantiles, with_leading(q, start), with_leading(1, count), slice);
    }
  }
}

void write_varying_field(hid_t file, const FieldInfo& info, const scene::Scene& scene,
                         const std::vector<Block>& blocks) {
  const auto& probabilities = scene.run.quantiles;
  const double quantum = info.whole ? 1.0 : base::FixedPoint(info.scale).quantum();
  const auto group = h5::make_group(file, "/fields/" + info.name);
  h5::set(group, "unit", info.unit);
  h5::set(group, "quantum", quantum);
  set_homes(group, info, scene);
  const auto dims = shape_of(info, blocks.size());
  const auto mean = h5::make_dataset<double>(group, "mean", dims);
  h5::set(mean, "unit", info.unit);
  const auto variance = h5::make_dataset<double>(group, "variance", dims);
  h5::set(variance, "unit", squared(info.unit));
  const auto quantiles = h5::make_dataset<double>(group, "quantiles", with_leading(probabilities.size(), dims));
  h5::set(quantiles, "unit", info.unit);
  h5::set(quantiles, "probabilities", probabilities);
  h5::set(quantiles, "bin_width_relative", 1.0 / 64);
  h5::set(quantiles, "bin_width_smallest", quantum);
  write_slices(mean, variance, quantiles, info, blocks, probabilities);
}

struct Summary {
  std::vector<double> mean, variance, error, quantiles;
};

// From the values of the finished realisations, in the order of their numbers.
Summary summarise(std::span<const double> values, std::size_t size, const std::vector<std::uint8_t>& done,
                  const std::vector<double>& probabilities) {
  Summary out{std::vector<double>(size, no_number), std::vector<double>(size, no_number),
              std::vector<double>(size, no_number), std::vector<double>(size * probabilities.size(), no_number)};
  std::vector<double> sample;
  for (std::size_t c = 0; c < size; ++c) {
    sample.clear();
    for (std::size_t k = 0; k < done.size(); ++k) {
      if (done[k] != 0) sample.push_back(values[k * size + c]);
    }
    const auto n = static_cast<double>(sample.size());
    if (sample.empty()) continue;
    long double sum = 0, squares = 0;
    for (const auto x : sample) sum += x;
    const long double mean = sum / static_cast<long double>(sample.size());
    for (const auto x : sample) squares += (x - mean) * (x - mean);
    out.mean[c] = static_cast<double>(mean);
    if (sample.size() > 1) {
      out.variance[c] = static_cast<double>(squares) / (n - 1);
      out.error[c] = std::sqrt(out.variance[c] / n);
    }
    std::sort(sample.begin(), sample.end());
    for (std::size_t q = 0; q < probabilities.size(); ++q) {
      const auto rank = std::ceil(probabilities[q] * n * (1 - 1e-15));
      out.quantiles[q * size + c] = sample[static_cast<std::size_t>(std::clamp(rank, 1.0, n)) - 1];
    }
  }
  return out;
}

void write_observable(hid_t file, const FieldInfo& info, const Results& results, std::size_t o,
                      const std::vector<double>& probabilities) {
  const auto times = results.layout.times.size();
  const auto size = times * cells(info);
  // What all realisations share is one row of values, known from the start.
  const auto& known = info.shared ? results.shared_observables[o] : results.values[o];
  const std::vector<double> nothing(known.empty() ? size : 0, no_number);
  const auto& values = known.empty() ? nothing : known;
  const auto rows = info.shared ? std::vector<std::uint8_t>{1} : results.done;
  const auto summary = summarise(values, size, rows, probabilities);

  const auto group = h5::make_group(file, "/observables/" + info.name);
  h5::set(group, "unit", info.unit);
  h5::set(group, "shared", static_cast<std::int64_t>(info.shared));
  h5::link(file, "/time", "/observables/" + info.name + "/time");
  const auto dims = shape_of(info, times);
  const auto write = [&](const char* name, const h5::Dims& shape, const std::vector<double>& data,
                         const std::string& unit) {
    auto dataset = h5::write<double>(group, name, shape, data);
    h5::set(dataset, "unit", unit);
    return dataset;
  };
  write("mean", dims, summary.mean, info.unit);
  write("variance", dims, summary.variance, squared(info.unit));
  write("standard_error", dims, summary.error, info.unit);
  const auto quantiles = write("quantiles", with_leading(probabilities.size(), dims), summary.quantiles, info.unit);
  h5::set(quantiles, "probabilities", probabilities);
  write("values", with_leading(rows.size(), dims), values, info.unit);
  if (!info.axis.empty()) write("axis", {info.axis.size()}, info.axis, "m");
}

}  // namespace

void write_statistics(hid_t file, const Description& description, const Results& results) {
  const auto& layout = results.layout;
  h5::make_group(file, "/fields");
  for (std::size_t f = 0; f < layout.fields.size(); ++f) {
    const auto& info = layout.fields[f];
    if (info.shared)
      write_shared_field(file, info, description.scene, layout.times.size(), results.shared_fields[f]);
    else
      write_varying_field(file, info, description.scene, results.blocks[f]);
  }
  h5::make_group(file, "/observables");
  for (std::size_t o = 0; o < layout.observables.size(); ++o) {
    write_observable(file, layout.observables[o], results, o, description.scene.run.quantiles);
  }
}

}  // namespace shmoo::run
