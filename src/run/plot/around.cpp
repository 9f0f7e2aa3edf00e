// A field round a ring: every particle with its spread, and the mean over sectors.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "run/plot/gnuplot.hpp"
#include "run/plot/plot.hpp"

namespace shmoo::run {
namespace {

struct Place {
  double x = 0, y = 0;
};

Place middle_of(const std::vector<double>& positions, const std::vector<std::size_t>& particles) {
  Place sum;
  for (const auto i : particles) sum.x += positions[3 * i], sum.y += positions[3 * i + 1];
  const auto n = static_cast<double>(particles.size());
  return {sum.x / n, sum.y / n};
}

// Means over sectors of equal angle that hold at least one particle; one sector more closes the circle.
std::vector<std::vector<double>> sector_means(const std::vector<double>& angle, const std::vector<double>& mean) {
  const auto sectors = std::clamp<std::size_t>(angle.size() / 4, 8, 36);
  std::vector<double> sum(sectors, 0), count(sectors, 0);
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const auto s =
        std::min(sectors - 1, static_cast<std::size_t>((angle[i] + 180) / 360 * static_cast<double>(sectors)));
    sum[s] += mean[i], count[s] += 1;
  }
  std::vector<std::vector<double>> out(2);
  for (std::size_t s = 0; s < sectors; ++s) {
    if (count[s] == 0) continue;
    out[0].push_back(-180 + (static_cast<double>(s) + 0.5) * 360 / static_cast<double>(sectors));
    out[1].push_back(sum[s] / count[s]);
  }
  return out;
}

}  // namespace

void plot_around(const ResultFile& result, const Entry& field, std::size_t time, const std::filesystem::path& png) {
  if (result.dimension != 2)
    throw base::InputError(fmt::format("--around draws fields of 2-D results; this one is {}-D", result.dimension));
  const auto positions = result.positions(time);
  const auto held = holders(result, field);
  std::vector<std::size_t> particles;
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) particles.push_back(i);
  }
  if (particles.empty()) throw base::InputError(fmt::format("no particle holds field {}", field.name));
  const auto middle = middle_of(positions, particles);
  const auto components = field.shape.size() > 1 ? field.shape[1] : 1;
  const auto slice = result.field_slice(field, time);
  const auto mean = magnitudes(slice.mean, components);
  const bool spread = slice.quantiles.size() >= 2 && components == 1;

  std::vector<double> angle, value, low, high;
  for (const auto i : particles) {
    angle.push_back(std::atan2(positions[3 * i + 1] - middle.y, positions[3 * i] - middle.x) * 180 / std::numbers::pi);
    value.push_back(mean[i]);
    low.push_back(spread ? slice.quantiles.front()[i] : mean[i]);
    high.push_back(spread ? slice.quantiles.back()[i] : mean[i]);
  }
  const auto reading = readable(field.unit, largest_magnitude(high));
  const Gnuplot gnuplot;
  gnuplot.table("particles",
                {angle, scaled(value, reading.factor), scaled(low, reading.factor), scaled(high, reading.factor)});
  gnuplot.table("sectors", sector_means(angle, scaled(value, reading.factor)));
  auto script = axes_style();
  script += fmt::format("set label 1 {} at screen 0.016,0.965 left font ',13' textcolor rgb '#111111'\n",
                        quoted(result.title));
  script +=
      fmt::format("set label 2 {} at screen 0.016,0.915 left font ',11' textcolor rgb '#444444'\n",
                  quoted(fmt::format("{} round the middle of its {} particles, {}, {}", field.name, particles.size(),
                                     ensemble_text(result, field), time_text(result.times[time]))));
  script +=
      "set tmargin at screen 0.82\nset bmargin at screen 0.12\nset lmargin at screen 0.115\nset rmargin at screen "
      "0.97\n"
      "set key at screen 0.97,0.875 right center horizontal samplen 2 font ',10' textcolor rgb '#333333'\n"
      "set grid back lw 0.5 lc rgb '#e6e6e6'\nset xrange [-180:180]\nset xtics 45\n";
  script += fmt::format("set xlabel 'angle from the x axis (degrees)'\nset ylabel {} offset 0.5,0\nset yrange [{}:*]\n",
                        quoted(with_unit(field.name + " per particle", reading.unit)),
                        largest_magnitude(high) == 0 ? "-1" : "0<*");
  script += "plot ";
  if (spread) {
    script += fmt::format(
        "'particles' using 1:2:3:4 with yerrorbars pt 7 ps 0.01 lw 1.1 lc rgb '#a8c6d0' title {}, ",
        quoted(fmt::format("{:g} % to {:g} %", 100 * field.probabilities.front(), 100 * field.probabilities.back())));
  }
  script += fmt::format(
      "'particles' using 1:2 with points pt 7 ps 0.7 lc rgb '{}' title 'mean of a particle', 'sectors' using 1:2 with "
      "lines lw "
      "2.2 lc rgb '{}' title 'mean of a sector'\n",
      main_colour, accent_colour);
  gnuplot.draw(script, 900, 560, png);
}

}  // namespace shmoo::run
