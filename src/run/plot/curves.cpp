#include "run/plot/curves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "run/plot/gnuplot.hpp"
#include "run/plot/plot.hpp"

namespace shmoo::run {
namespace {

std::string percent(double p) { return fmt::format("{:g} %", 100 * p); }

// Head, labels and a range with some air.
std::string frame(const Curve& curve, const std::string& unit, std::span<const double> shown) {
  auto range = range_of(shown, false);
  if (range.low >= 0 && range.low < 0.5 * range.high) range.low = 0;
  const double air = 0.05 * (range.high - range.low);
  auto script = curve_style(curve.heading, curve.title);
  script += fmt::format("set xlabel {}\nset ylabel {} offset 0.5,0\nset yrange [{}:{}]\n", quoted(curve.x_label),
                        quoted(with_unit(curve.name, unit)), range.low == 0 ? 0 : range.low - air, range.high + air);
  return script;
}

}  // namespace

void draw_curve(const Curve& curve, const std::filesystem::path& png) {
  auto magnitude = largest_magnitude(curve.y.mean);
  const auto reading = readable(curve.unit, magnitude);
  const Gnuplot gnuplot;
  std::vector<double> shown = scaled(curve.y.mean, reading.factor);
  std::vector<std::vector<double>> columns{curve.x, shown};
  std::string plot;
  const auto add = [&](const std::string& part) { plot += (plot.empty() ? "plot " : ", \\\n  ") + part; };

  if (curve.y.quantiles.size() >= 2) {
    const auto low = scaled(curve.y.quantiles.front(), reading.factor),
               high = scaled(curve.y.quantiles.back(), reading.factor);
    shown.insert(shown.end(), low.begin(), low.end());
    shown.insert(shown.end(), high.begin(), high.end());
    gnuplot.table("band", {curve.x, low, high});
    add(fmt::format(
        "'band' using 1:2:3 with filledcurves fc rgb '{}' fs transparent solid 0.16 noborder title {}", main_colour,
        quoted(fmt::format("{} to {}", percent(curve.probabilities.front()), percent(curve.probabilities.back())))));
  }
  for (std::size_t e = 0; e < curve.examples.size(); ++e) {
    const auto example = scaled(curve.examples[e], reading.factor);
    shown.insert(shown.end(), example.begin(), example.end());
    gnuplot.table(fmt::format("example{}", e), {curve.x, example});
    add(fmt::format("'example{}' using 1:2 with lines lw 0.8 lc rgb '{}' {}", e, faint_colour,
                    e == 0 ? "title 'single realisations'" : "notitle"));
  }
  if (!curve.y.error.empty()) {
    std::vector<double> low, high;
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      low.push_back(columns[1][i] - reading.factor * curve.y.error[i]);
      high.push_back(columns[1][i] + reading.factor * curve.y.error[i]);
    }
    gnuplot.table("error", {curve.x, low, high});
    add(
        fmt::format("'error' using 1:2:3 with filledcurves fc rgb '{}' fs transparent solid 0.38 noborder title 'mean "
                    "± standard error'",
                    main_colour));
  }
  gnuplot.table("mean", columns);
  add(fmt::format("'mean' using 1:2 with {} lw 2 lc rgb '{}' pt 7 ps 0.5 {}", curve.points ? "linespoints" : "lines",
                  main_colour, curve.y.error.empty() ? "notitle" : "title 'mean'"));
  gnuplot.draw(frame(curve, reading.unit, shown) + plot + "\n", curve_width, curve_height, png);
}

void plot_line(const ResultFile& result, const Entry& field, std::size_t time, const std::filesystem::path& png) {
  const auto positions = result.positions(time);
  const auto held = holders(result, field);
  const auto components = field.shape.size() > 1 ? field.shape[1] : 1;
  const auto slice = result.field_slice(field, time);
  const auto length = readable("m", result.upper[0] - result.lower[0]);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i] && !std::isnan(positions[3 * i])) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return positions[3 * a] < positions[3 * b]; });
  const auto arranged = [&](const std::vector<double>& values) {
    std::vector<double> out;
    if (values.empty()) return out;
    for (const auto i : order) out.push_back(values[components * i]);
    return out;
  };
  Curve curve{
      .heading = result.title,
      .title = fmt::format("{}, {}, {}", field.name, ensemble_text(result, field), time_text(result.times[time])),
      .x_label = with_unit("x", length.unit),
      .name = field.name,
      .unit = field.unit,
      .x = {},
      .y = {},
      .probabilities = field.probabilities,
      .examples = {},
      .points = order.size() <= 80};
  for (const auto i : order) curve.x.push_back(length.factor * positions[3 * i]);
  curve.y.mean = arranged(slice.mean);
  curve.y.error = arranged(slice.error);
  for (const auto& quantile : slice.quantiles) curve.y.quantiles.push_back(arranged(quantile));
  draw_curve(curve, png);
}

void plot_observable(const ResultFile& result, const Entry& observable, std::size_t time,
                     const std::filesystem::path& png) {
  const auto course = result.course(observable);
  const bool profile = !observable.shape.empty();
  const auto bins = observable.cells(), times = result.times.size();
  // A course takes cell 0 at every time, a profile every cell at one time.
  const auto part = [&](std::span<const double> values) {
    std::vector<double> out;
    if (values.empty()) return out;
    const auto from = values.subspan(profile ? time * bins : 0, profile ? bins : times);
    return std::vector<double>(from.begin(), from.end());
  };
  const auto reading =
      profile ? readable("m", largest_magnitude(observable.axis)) : readable("s", largest_magnitude(result.times));
  Curve curve{.heading = result.title,
              .title = fmt::format("{}, {}{}", observable.name, ensemble_text(result, observable),
                                   profile ? ", " + time_text(result.times[time]) : ""),
              .x_label = with_unit(profile ? "position" : "time", reading.unit),
              .name = observable.name,
              .unit = observable.unit,
              .x = scaled(profile ? observable.axis : result.times, reading.factor),
              .y = {},
              .probabilities = observable.probabilities,
              .examples = {}};
  if (profile && curve.x.size() != bins) {
    curve.x.resize(bins);
    for (std::size_t b = 0; b < bins; ++b) curve.x[b] = static_cast<double>(b);
    curve.x_label = "bin";
  }
  curve.y = {part(course.all.mean), part(course.all.deviation), part(course.all.error), {}};
  for (const auto& quantile : course.all.quantiles) curve.y.quantiles.push_back(part(quantile));
  if (course.realisations > 1) {
    for (std::size_t k = 0; k < std::min<std::size_t>(4, course.realisations); ++k) {
      curve.examples.push_back(part(std::span(course.values).subspan(k * times * bins, times * bins)));
    }
  }
  draw_curve(curve, png);
}

std::vector<bool> holders(const ResultFile& result, const Entry& field) {
  std::vector<bool> material(result.material_names.size());
  const bool of_fluid = field.name == "velocity" || field.name == "density" || field.name == "pressure";
  for (std::size_t m = 0; m < material.size(); ++m) {
    const auto& homes = field.materials;
    material[m] = homes.empty() ? !(of_fluid && result.material_types[m] == "wall")
                                : std::find(homes.begin(), homes.end(), result.material_names[m]) != homes.end();
  }
  std::vector<bool> held;
  for (const auto m : result.material) held.push_back(m >= 0 && material[static_cast<std::size_t>(m)]);
  return held;
}

std::vector<double> magnitudes(const std::vector<double>& values, std::size_t components) {
  if (components == 1) return values;
  std::vector<double> out(values.size() / components, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) out[i / components] += values[i] * values[i];
  for (auto& value : out) value = std::sqrt(value);
  return out;
}

std::string ensemble_text(const ResultFile& result, const Entry& entry) {
  if (!entry.varying) return "the same in all realisations";
  return result.done == 1 ? "one realisation" : fmt::format("mean of {} realisations", result.done);
}

}  // namespace shmoo::run
