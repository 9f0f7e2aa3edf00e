// A field round a ring: every particle with its spread, and the course round the ring.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/error.hpp"
#include "run/plot/gnuplot.hpp"
#include "run/plot/plot.hpp"

namespace shmoo::run {
namespace {

constexpr std::size_t few = 48;  // particles

struct Place {
  double x = 0, y = 0;
};

Place middle_of(const std::vector<double>& positions, const std::vector<std::size_t>& particles) {
  Place sum;
  for (const auto i : particles) sum.x += positions[3 * i], sum.y += positions[3 * i + 1];
  const auto n = static_cast<double>(particles.size());
  return {sum.x / n, sum.y / n};
}

// The course round the ring: of few particles their own values, of many the means over sectors of equal angle. Its ends
// are repeated beyond +-180 degrees, so that the line closes.
std::vector<std::vector<double>> course_of(const std::vector<double>& angle, const std::vector<double>& mean) {
  std::map<double, double> course;
  if (angle.size() <= few) {
    for (std::size_t i = 0; i < angle.size(); ++i) course[angle[i]] = mean[i];
  } else {
    const auto sectors = std::min<std::size_t>(angle.size() / 4, 36);
    const double width = 360 / static_cast<double>(sectors);
    std::map<double, std::pair<double, double>> sums;  // by the sector's middle: sum, count
    for (std::size_t i = 0; i < angle.size(); ++i) {
      auto& [sum, count] = sums[-180 + (std::floor((angle[i] + 180) / width) + 0.5) * width];
      sum += mean[i], count += 1;
    }
    for (const auto& [middle, sum] : sums) course[middle] = sum.first / sum.second;
  }
  std::vector<std::vector<double>> out{{course.rbegin()->first - 360}, {course.rbegin()->second}};
  for (const auto& [at, value] : course) out[0].push_back(at), out[1].push_back(value);
  out[0].push_back(course.begin()->first + 360);
  out[1].push_back(course.begin()->second);
  return out;
}

// Angles [degrees] about the ring's middle, and statistics of every particle.
struct Ring {
  std::vector<double> angle, mean, low, high;
  bool spread = false;
};

Ring ring_of(const ResultFile& result, const Entry& field, std::size_t time) {
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
  Ring ring;
  ring.spread = slice.quantiles.size() >= 2 && components == 1;
  for (const auto i : particles) {
    ring.angle.push_back(std::atan2(positions[3 * i + 1] - middle.y, positions[3 * i] - middle.x) * 180 /
                         std::numbers::pi);
    ring.mean.push_back(mean[i]);
    ring.low.push_back(ring.spread ? slice.quantiles.front()[i] : mean[i]);
    ring.high.push_back(ring.spread ? slice.quantiles.back()[i] : mean[i]);
  }
  return ring;
}

}  // namespace

void plot_around(const ResultFile& result, const Entry& field, std::size_t time, const std::filesystem::path& png) {
  if (result.dimension != 2) {
    throw base::InputError(fmt::format("--around draws fields of 2-D results; this one is {}-D", result.dimension));
  }
  const auto ring = ring_of(result, field, time);
  const auto largest = largest_magnitude(ring.high);
  const auto reading = readable(field.unit, largest);
  const bool many = ring.angle.size() > few;
  const auto mean = scaled(ring.mean, reading.factor);
  const Gnuplot gnuplot;
  gnuplot.table("particles", {ring.angle, mean, scaled(ring.low, reading.factor), scaled(ring.high, reading.factor)});
  gnuplot.table("course", course_of(ring.angle, mean));

  auto script = curve_style(
      result.title, fmt::format("{} round the middle of its {} particles, {}, {}", field.name, ring.angle.size(),
                                ensemble_text(result, field), time_text(result.times[time])));
  script += fmt::format(
      "set xrange [-180:180]\nset xtics 45\nset xlabel 'angle from the x axis (degrees)'\nset ylabel {} offset 0.5,0\n"
      "set yrange [{}]\nplot ",
      quoted(with_unit(field.name + " per particle", reading.unit)), largest == 0 ? "-1:1" : "0<*:*");
  if (ring.spread) {
    script += fmt::format(
        "'particles' using 1:3:(0):($4-$3) with vectors nohead lw {} lc rgb '#c3dae1' title {}, ", many ? 1.5 : 7,
        quoted(fmt::format("{:g} % to {:g} %", 100 * field.probabilities.front(), 100 * field.probabilities.back())));
  }
  const auto dots = fmt::format("'particles' using 1:2 with points pt 7 ps {} lc rgb '{}' title 'mean of a particle'",
                                many ? 0.5 : 1.1, main_colour);
  const auto line = fmt::format("'course' using 1:2 with lines lw {} lc rgb '{}' {}", many ? 3 : 2, accent_colour,
                                many ? "title 'mean of a sector'" : "notitle");
  script += many ? dots + ", " + line + "\n" : line + ", " + dots + "\n";
  gnuplot.draw(script, curve_width, curve_height, png);
}

}  // namespace shmoo::run
