#include "run/study/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "run/plot/gnuplot.hpp"
#include "run/plot/style.hpp"

namespace shmoo::run::study {
namespace {

// Told apart also by colour-blind eyes (M. Okabe and K. Ito 2008), and by their symbols; beyond eight methods colours
// come again, with other symbols and dashes.
constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#999999"};
constexpr std::array symbols{7, 5, 9, 13, 11, 15, 6, 4, 8, 12, 10, 14, 3};

// Beside the plot, as wide as its longest line, one line below the other.
struct Legend {
  static constexpr double sample = 62, letter = 6.4;  // [pixels]
  double width = 0;

  explicit Legend(std::span<const std::string> names) {
    std::size_t longest = 0;
    for (const auto& name : names) longest = std::max(longest, name.size());
    width = std::min(sample + letter * double(longest), 0.45 * curve_width);
  }
  std::string script() const {
    return fmt::format(
        "set key at screen 0.985,0.80 right top vertical maxrows auto Left reverse samplen 2.4\nset rmargin at screen "
        "{:.4f}\n",
        1.0 - width / curve_width);
  }
};

struct Line {
  std::string method;
  std::vector<double> cpu, error, low, high;
};

bool shown(const Row& row) { return std::isfinite(row.error) && row.error > 0 && row.cpu_seconds > 0; }

std::vector<Line> lines_of(const Verdict& verdict) {
  std::vector<Line> lines;
  for (const auto& row : verdict.rows) {
    if (!shown(row)) continue;
    if (lines.empty() || lines.back().method != row.method) lines.push_back({row.method, {}, {}, {}, {}});
    auto& line = lines.back();
    const double spread = std::isfinite(row.spread) ? row.spread : 0.0;
    line.cpu.push_back(row.cpu_seconds);
    line.error.push_back(row.error);
    line.low.push_back(std::max(row.error - spread, 0.1 * row.error));
    line.high.push_back(row.error + spread);
  }
  return lines;
}

// A staircase: at a CPU time, the least error that can be had for it.
std::vector<std::vector<double>> front_of(const Verdict& verdict) {
  std::vector<std::pair<double, double>> front;
  for (const auto& row : verdict.rows)
    if (row.pareto && shown(row)) front.emplace_back(row.cpu_seconds, row.error);
  std::sort(front.begin(), front.end());
  std::vector<std::vector<double>> columns(2);
  for (const auto& [cpu, error] : front) columns[0].push_back(cpu), columns[1].push_back(error);
  return columns;
}

struct Limits {
  double low = std::numeric_limits<double>::infinity(), high = 0.0;
  void hold(const std::vector<double>& values) {
    for (const double value : values) low = std::min(low, value), high = std::max(high, value);
  }
  // With some air, and at least a decade, so that tics have numbers.
  double air() const { return std::max(1.4, std::sqrt(10.0 * low / high)); }
  std::string range() const { return fmt::format("[{:.6g}:{:.6g}]", low / air(), high * air()); }
  // A number at each power of ten (every second one and so on, where there are many).
  std::string tics() const {
    const int first = int(std::floor(std::log10(low / air()))), last = int(std::ceil(std::log10(high * air())));
    const int every = 1 + (last - first) / 8;
    std::string list;
    for (int power = first; power <= last; ++power) {
      const bool named = (power - first) % every == 0;
      list += fmt::format("{}'{}' 1e{} 0", list.empty() ? "" : ", ", named ? power_of_ten(power) : "", power);
      for (int digit = 2; digit < 10 && every == 1; ++digit) list += fmt::format(", '' {}e{} 1", digit, power);
    }
    return "(" + list + ")";
  }
};

}  // namespace

bool draw_work_precision(const std::string& title, const Verdict& verdict, const std::filesystem::path& png) {
  const auto lines = lines_of(verdict);
  if (lines.empty()) return false;
  const Gnuplot gnuplot;
  Limits cpu, error;
  std::string plot;
  std::vector<std::string> names{"Pareto front"};
  const auto front = front_of(verdict);
  gnuplot.table("front", front);
  plot = fmt::format(
      "plot 'front' using 1:2 with steps lw 6 lc rgb '#e3dfd6' title 'Pareto front', \\\n"
      "  'front' using 1:2 with points pt 6 ps 2.6 lw 1.2 lc rgb '#8a8578' notitle");
  for (std::size_t l = 0; l < lines.size(); ++l) {
    const auto& line = lines[l];
    cpu.hold(line.cpu), error.hold(line.low), error.hold(line.high);
    gnuplot.table(fmt::format("line{}", l), {line.cpu, line.error, line.low, line.high});
    plot += fmt::format(
        ", \\\n  'line{0}' using 1:2:3:4 with yerrorbars pt {1} ps 1.1 lw 1.2 lc rgb '{2}' notitle"
        ", \\\n  'line{0}' using 1:2 with linespoints pt {1} ps 1.1 lw 1.6 dt {4} lc rgb '{2}' title {3}",
        l, symbols[l % symbols.size()], colours[l % colours.size()], quoted(line.method), 1 + l / colours.size() % 4);
    names.push_back(line.method);
  }
  auto script = curve_style(title, fmt::format("{}: error ({}) against CPU time", verdict.quantity, verdict.norm));
  script += fmt::format(
      "set tmargin at screen 0.84\nset logscale xy\nset xtics {}\nset ytics {}\nset "
      "xlabel 'CPU time of one run "
      "(s)'\nset ylabel 'error' offset 0.5,0\nset xrange {}\nset yrange {}\n",
      cpu.tics(), error.tics(), cpu.range(), error.range());
  script += Legend(names).script();
  gnuplot.draw(script + plot + "\n", curve_width, curve_height, png);
  return true;
}

}  // namespace shmoo::run::study
