#include "run/study/sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/error.hpp"
#include "run/plot/plot.hpp"
#include "run/study/oscillation.hpp"

namespace shmoo::run::study {
namespace {

std::vector<std::size_t> records(const ResultFile& result, const std::vector<double>& times) {
  if (times.empty()) return {result.times.size() - 1};
  std::vector<std::size_t> found;
  for (const double time : times) {
    found.push_back(result.nearest_time(time));
    if (std::abs(result.times[found.back()] - time) > 1e-9 * result.times.back())
      throw base::RunError(
          fmt::format("there is no record at {:g} s; the nearest is at {:g} s", time, result.times[found.back()]));
  }
  return found;
}

void add_place(Sample& sample, double x, double y, double z, double t, double value) {
  sample.x.push_back(x), sample.y.push_back(y), sample.z.push_back(z), sample.t.push_back(t);
  sample.value.push_back(value);
}

// A species counts molecules; what is compared is its concentration.
void add_field(const ResultFile& result, const scene::StudyQuantity& quantity, std::size_t time, Sample& sample) {
  const auto& entry = result.field(quantity.field);
  const auto slice = result.field_slice(entry, time);
  const auto places = result.positions(time);
  const auto held = holders(result, entry);
  const std::size_t components = entry.shape.size() > 1 ? entry.shape[1] : 1;
  std::vector<double> volume;
  if (entry.unit == "molecules") volume = result.field_slice(result.field("volume"), time).mean;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i] || std::isnan(places[3 * i])) continue;
    const std::size_t cell = i * components + std::min(quantity.component, components - 1);
    const double factor = volume.empty() ? 1.0 : 1.0 / volume[i];
    add_place(sample, places[3 * i], places[3 * i + 1], places[3 * i + 2], result.times[time],
              factor * slice.mean[cell]);
    if (!slice.deviation.empty()) sample.variance.push_back(std::pow(factor * slice.deviation[cell], 2));
  }
}

void add_observable(const ResultFile& result, const Entry& entry, const Course& course, std::size_t time,
                    std::size_t axis, Sample& sample) {
  const auto cells = entry.cells();
  for (std::size_t b = 0; b < cells; ++b) {
    std::array<double, 3> place{};
    if (b < entry.axis.size()) place[axis] = entry.axis[b];
    add_place(sample, place[0], place[1], place[2], result.times[time], course.all.mean[time * cells + b]);
    if (!course.all.deviation.empty()) sample.variance.push_back(std::pow(course.all.deviation[time * cells + b], 2));
  }
}

std::vector<std::size_t> records_in(const ResultFile& result, const std::array<double, 2>& window) {
  std::vector<std::size_t> found;
  for (std::size_t t = 0; t < result.times.size(); ++t)
    if (result.times[t] >= window[0] && result.times[t] <= window[1]) found.push_back(t);
  if (found.empty()) throw base::RunError("no record lies in the window of time");
  return found;
}

// The mean of a profile over the records in the window.
void add_average_profile(const Entry& entry, const Course& course, const std::vector<std::size_t>& window, double time,
                         std::size_t axis, Sample& sample) {
  const auto cells = entry.cells();
  for (std::size_t b = 0; b < cells; ++b) {
    std::array<double, 3> place{};
    if (b < entry.axis.size()) place[axis] = entry.axis[b];
    double sum = 0.0;
    for (const auto t : window) sum += course.all.mean[t * cells + b];
    add_place(sample, place[0], place[1], place[2], time, sum / double(window.size()));
  }
}

// The mean of each realisation over the records in the window, then over realisations.
void add_average(const ResultFile& result, const Course& course, const std::vector<std::size_t>& window, double time,
                 Sample& sample) {
  const std::size_t times = result.times.size(), n = course.realisations > 0 ? course.realisations : 1;
  const auto& values = course.realisations > 0 ? course.values : course.all.mean;
  std::vector<double> means;
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0.0;
    for (const auto t : window) sum += values[k * times + t];
    means.push_back(sum / double(window.size()));
  }
  double mean = 0.0, squares = 0.0;
  for (const double one : means) mean += one / double(n);
  for (const double one : means) squares += (one - mean) * (one - mean);
  add_place(sample, 0, 0, 0, time, mean);
  if (n > 1) sample.variance.push_back(squares / double(n - 1));
}

// A number that the course of the mean over realisations has in a window of time; not finite where it has none.
struct Swing {
  std::optional<std::array<double, 2>> scene::StudyQuantity::*window;
  double (*number)(std::span<const double> time, std::span<const double> value);
};

constexpr Swing swings[] = {
    {&scene::StudyQuantity::amplitude, [](auto, auto value) { return half_range(value); }},
    {&scene::StudyQuantity::period, first_period},
    {&scene::StudyQuantity::harmonic, [](auto time, auto value) { return strongest_harmonic(time, value).amplitude; }},
    {&scene::StudyQuantity::harmonic_period,
     [](auto time, auto value) { return strongest_harmonic(time, value).period; }}};

void add_swing(const ResultFile& result, const Entry& entry, const Course& course, const Swing& swing,
               const std::array<double, 2>& window, Sample& sample) {
  if (entry.cells() != 1) throw base::RunError(fmt::format("{} is a profile; only a number swings", entry.name));
  std::vector<double> time, value;
  for (const auto t : records_in(result, window)) {
    time.push_back(result.times[t]);
    value.push_back(course.all.mean[t]);
  }
  const double number = swing.number(time, value);
  if (!std::isfinite(number))
    throw base::RunError(
        fmt::format("{} does not swing through a whole period in the window of time, which holds {} records",
                    entry.name, time.size()));
  add_place(sample, 0, 0, 0, window[1], number);
}

double mean_of(const std::vector<std::uint64_t>& values) {
  double sum = 0.0;
  for (const auto value : values) sum += double(value);
  return values.empty() ? 0.0 : sum / double(values.size());
}

}  // namespace

Sample take(const ResultFile& result, const scene::StudyQuantity& quantity) {
  Sample sample;
  if (!quantity.field.empty()) {
    for (const auto time : records(result, quantity.times)) add_field(result, quantity, time, sample);
    return sample;
  }
  const auto& entry = result.observable(quantity.observable);
  const auto course = result.course(entry);
  if (quantity.average) {
    const auto window = records_in(result, *quantity.average);
    const double end = (*quantity.average)[1];
    if (entry.cells() == 1)
      add_average(result, course, window, end, sample);
    else
      add_average_profile(entry, course, window, end, quantity.axis, sample);
    return sample;
  }
  for (const auto& swing : swings)
    if (const auto& window = quantity.*swing.window) {
      add_swing(result, entry, course, swing, *window, sample);
      return sample;
    }
  for (const auto time : records(result, quantity.times))
    add_observable(result, entry, course, time, quantity.axis, sample);
  return sample;
}

void take_account(const ResultFile& result, const scene::Study& study, const Task& task, Point& point) {
  const auto provenance = h5::open(result.id(), "/provenance");
  point.cpu_per_realisation = h5::get_number(provenance, "cpu_seconds_per_realisation");
  point.revision = h5::get_text(provenance, "revision");
  const auto names = h5::read_texts(result.id(), "/derived/name");
  const auto values = h5::read<double>(result.id(), "/derived/value");
  const auto derived = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? unknown : values[std::size_t(found - names.begin())];
  };
  point.steps = derived("flow steps");
  if (!std::isfinite(point.steps)) point.steps = std::ceil(result.times.back() / derived("time step"));
  if (!std::isfinite(point.steps)) point.steps = derived("intervals");
  point.events = mean_of(h5::read<std::uint64_t>(result.id(), "/realisations/reaction_events")) +
                 mean_of(h5::read<std::uint64_t>(result.id(), "/realisations/jump_events"));
  point.resolution = derived(study.resolution);
  if (!std::isfinite(point.resolution))
    point.resolution = scene::number_in_model(task.model_text, study.resolution).value;
}

}  // namespace shmoo::run::study
