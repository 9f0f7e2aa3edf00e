// Maps of particle fields.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "run/plot/gnuplot.hpp"
#include "run/plot/plot.hpp"
#include "run/plot/raster.hpp"

namespace shmoo::run {
namespace {

struct Panel {
  std::string title, bar;
  std::vector<double> values;
  Range range;
};

// Everything that is to be drawn, in readable lengths.
struct Map {
  std::vector<double> points;  // x, y in turn
  Window window;
  double reach = 1;
  std::string unit;           // of lengths
  std::vector<Colour> greys;  // by point, where it does not hold the field
  std::vector<Panel> panels;
  std::vector<std::array<double, 4>> arrows;
};

// Particles of the picture: all in 2-D, the middle layer in 3-D.
std::vector<std::size_t> shown_particles(const ResultFile& result, const std::vector<double>& positions) {
  std::vector<std::size_t> shown;
  const double middle = 0.5 * (result.lower[2] + result.upper[2]);
  // Of an even number of layers, the one just below the middle.
  for (std::size_t i = 0; 3 * i < positions.size(); ++i) {
    if (std::isnan(positions[3 * i])) continue;  // nothing is there now
    const double off = positions[3 * i + 2] - middle;
    if (result.dimension < 3 || (off > -0.75 * result.spacing && off <= 0.25 * result.spacing)) shown.push_back(i);
  }
  return shown;
}

// The domain, or the surroundings of what holds the field where that is a small part of it.
Window window_of(const ResultFile& result, const std::vector<double>& points, const std::vector<bool>& held,
                 double factor) {
  const Window domain{factor * result.lower[0], factor * result.upper[0], factor * result.lower[1],
                      factor * result.upper[1]};
  Window box{domain.x1, domain.x0, domain.y1, domain.y0};
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (!held[i]) continue;
    box.x0 = std::min(box.x0, points[2 * i]), box.x1 = std::max(box.x1, points[2 * i]);
    box.y0 = std::min(box.y0, points[2 * i + 1]), box.y1 = std::max(box.y1, points[2 * i + 1]);
  }
  if (box.x0 > box.x1 || box.y0 > box.y1) return domain;
  const double side = std::max(box.x1 - box.x0, box.y1 - box.y0) + 3 * factor * result.spacing;
  if (side * side > 0.1 * (domain.x1 - domain.x0) * (domain.y1 - domain.y0)) return domain;
  const double x = 0.5 * (box.x0 + box.x1), y = 0.5 * (box.y0 + box.y1), half = 0.6 * side;
  return {std::max(domain.x0, x - half), std::min(domain.x1, x + half), std::max(domain.y0, y - half),
          std::min(domain.y1, y + half)};
}

std::vector<double> picked(const std::vector<double>& values, const std::vector<std::size_t>& shown,
                           const std::vector<bool>& held) {
  std::vector<double> out;
  for (const auto i : shown) out.push_back(held[i] ? values[i] : std::numeric_limits<double>::quiet_NaN());
  return out;
}

Panel make_panel(const std::string& title, const std::string& name, const std::string& unit,
                 std::vector<double> values) {
  const auto reading = readable(unit, largest_magnitude(values));
  values = scaled(std::move(values), reading.factor);
  const auto range = range_of(values, false);
  // Counts and speeds read best from zero; a density does not.
  const bool near_zero = range.low >= 0 && range.low < 0.5 * range.high;
  return {title, with_unit(name, reading.unit), values, range_of(values, near_zero)};
}

// In a body of revolution voxels next to the axis are small, and numbers of molecules would show that: concentrations.
std::string make_concentrations(const ResultFile& result, const Entry& field, std::size_t time, Slice& slice) {
  const auto volume = std::find_if(result.fields.begin(), result.fields.end(),
                                   [](const auto& other) { return other.name == "volume"; });
  if (!result.axisymmetric || field.unit != "molecules" || volume == result.fields.end()) return field.unit;
  const auto volumes = result.field_slice(*volume, time).mean;
  for (auto* values : {&slice.mean, &slice.deviation})
    for (std::size_t i = 0; i < values->size(); ++i) (*values)[i] /= volumes[i] * base::avogadro;
  return "mol/m³";
}

// The other half of a body of revolution.
void add_mirror_image(Map& map) {
  const std::size_t points = map.points.size() / 2;
  for (std::size_t i = 0; i < points; ++i) {
    map.points.push_back(map.points[2 * i]);
    map.points.push_back(-map.points[2 * i + 1]);
    map.greys.push_back(map.greys[i]);
    for (auto& panel : map.panels) panel.values.push_back(panel.values[i]);
  }
  map.window.y0 = -map.window.y1;
}

// One arrow in each cell of a coarse grid, at the cell's middle, as the particle nearest to it moves.
std::vector<std::array<double, 4>> arrows_of(const Map& map, const std::vector<double>& vectors, std::size_t components,
                                             const std::vector<std::size_t>& shown, const std::vector<bool>& held) {
  const auto& window = map.window;
  const double cell = std::max({window.x1 - window.x0, window.y1 - window.y0, 60 * map.reach / 1.2}) / 30;
  const int columns = std::max(1, static_cast<int>((window.x1 - window.x0) / cell)),
            rows = std::max(1, static_cast<int>((window.y1 - window.y0) / cell));
  const auto nearest = nearest_particles(map.points, window, columns, rows, map.reach);
  const auto largest = largest_magnitude(magnitudes(vectors, components));
  std::vector<std::array<double, 4>> arrows;
  if (!(largest > 0)) return arrows;
  const double width = (window.x1 - window.x0) / columns, height = (window.y1 - window.y0) / rows,
               length = 0.9 * std::min(width, height) / largest;
  for (std::size_t a = 0; a < nearest.size(); ++a) {
    if (nearest[a] < 0) continue;
    const auto i = shown[static_cast<std::size_t>(nearest[a])];
    if (!held[i]) continue;
    const double dx = length * vectors[components * i], dy = length * vectors[components * i + 1];
    const auto column = static_cast<double>(a % static_cast<std::size_t>(columns)),
               row = static_cast<double>(a / static_cast<std::size_t>(columns));
    arrows.push_back(
        {window.x0 + (column + 0.5) * width - 0.5 * dx, window.y0 + (row + 0.5) * height - 0.5 * dy, dx, dy});
  }
  return arrows;
}

// Pixel geometry of one panel and of the canvas.
struct Canvas {
  static constexpr int left = 82, right = 118, top = 34, bottom = 58, head = 34;
  int width = 0, height = 0, across = 1, down = 1;

  Canvas(const Map& map) {
    const double w = map.window.x1 - map.window.x0, h = map.window.y1 - map.window.y0;
    const double scale = std::min(860 / w, 560 / h);
    width = std::max(160, static_cast<int>(std::lround(scale * w)));
    height = std::max(90, static_cast<int>(std::lround(scale * h)));
    const auto panels = static_cast<int>(map.panels.size());
    (w > 1.25 * h ? down : across) = panels;
  }
  int total_width() const { return across * (left + width + right); }
  int total_height() const { return head + down * (top + height + bottom); }
};

std::string panel_script(const Canvas& canvas, const Map& map, const Panel& panel, int index) {
  const double w = canvas.total_width(), h = canvas.total_height();
  const int column = index % canvas.across, row = index / canvas.across;
  const double x0 = column * (Canvas::left + canvas.width + Canvas::right) + Canvas::left;
  const double y1 = h - Canvas::head - Canvas::top - row * (Canvas::top + canvas.height + Canvas::bottom),
               y0 = y1 - canvas.height;
  const auto& window = map.window;
  std::string script;
  script += fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at screen {}\n",
      x0 / w, (x0 + canvas.width) / w, y0 / h, y1 / h);
  script += fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\nset cbrange [{}:{}]\n", window.x0, window.x1,
                        window.y0, window.y1, panel.range.low, panel.range.high);
  script += fmt::format("set title {} offset 0,-0.6 font ',11' textcolor rgb '#222222'\n", quoted(panel.title));
  script += fmt::format(
      "set xlabel {} offset 0,0.4\nset ylabel {} offset 0.8,0\nset cblabel {} offset 0.6,0 textcolor rgb '#333333'\n",
      quoted(with_unit("x", map.unit)), quoted(with_unit("y", map.unit)), quoted(panel.bar));
  script += fmt::format("set colorbox vertical user origin screen {},{} size screen {},{} noborder\n",
                        (x0 + canvas.width + 14) / w, y0 / h, 14 / w, canvas.height / h);
  const double dx = (window.x1 - window.x0) / canvas.width, dy = (window.y1 - window.y0) / canvas.height;
  script += fmt::format(
      "plot 'panel{}' binary array=({},{}) format='%uchar%uchar%uchar' dx={} dy={} origin=({},{}) with rgbimage "
      "notitle, "
      "'bar' using 1:2:3 with points pt 0 lc palette notitle",
      index, canvas.width, canvas.height, dx, dy, window.x0 + 0.5 * dx, window.y0 + 0.5 * dy);
  if (!map.arrows.empty() && index == 0)
    script += ", 'arrows' using 1:2:3:4 with vectors head size screen 0.006,20 filled lw 1.1 lc rgb '#f7f7f7' notitle";
  return script + "\n";
}

void draw_map(const Map& map, const std::string& heading, const std::filesystem::path& png) {
  const Canvas canvas(map);
  const Gnuplot gnuplot;
  std::string script =
      axes_style() + viridis_palette() + "set border 15\nset cbtics scale 0.4 textcolor rgb '#333333'\n";
  script += fmt::format("set label 1 {} at screen {},{} left font ',13' textcolor rgb '#111111' front\n",
                        quoted(heading), 14.0 / canvas.total_width(), 1 - 17.0 / canvas.total_height());
  const auto& values = map.panels.front().values;
  if (std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); })) {
    script += fmt::format(
        "set label 2 'grey: holds none of it' at screen {},{} right font ',10' textcolor rgb '#777777' front\n",
        1 - 14.0 / canvas.total_width(), 1 - 17.0 / canvas.total_height());
  }
  script += "set multiplot\n";
  const auto pixels = nearest_particles(map.points, map.window, canvas.width, canvas.height, map.reach);
  gnuplot.table("bar", {{map.window.x0 - 1}, {map.window.y0 - 1}, {0}});
  if (!map.arrows.empty()) {
    std::vector<std::vector<double>> columns(4);
    for (const auto& arrow : map.arrows) {
      for (std::size_t c = 0; c < 4; ++c) columns[c].push_back(arrow[c]);
    }
    gnuplot.table("arrows", columns);
  }
  for (std::size_t p = 0; p < map.panels.size(); ++p) {
    gnuplot.bytes(fmt::format("panel{}", p), coloured(pixels, map.panels[p].values, map.panels[p].range, map.greys));
    script += panel_script(canvas, map, map.panels[p], static_cast<int>(p));
    script += "unset label 1\nunset label 2\n";
  }
  gnuplot.draw(script + "unset multiplot\n", canvas.total_width(), canvas.total_height(), png);
}

}  // namespace

void plot_map(const ResultFile& result, const Entry& field, std::size_t time, const PlotOptions& options,
              const std::filesystem::path& png) {
  const auto positions = result.positions(time);
  const auto shown = shown_particles(result, positions);
  const auto all_held = holders(result, field);
  auto slice = result.field_slice(field, time);
  const auto unit = make_concentrations(result, field, time, slice);
  const auto components = field.shape.size() > 1 ? field.shape[1] : 1;
  const auto length = readable("m", std::max(result.upper[0] - result.lower[0], result.upper[1] - result.lower[1]));

  Map map;
  map.unit = length.unit;
  std::vector<bool> held;
  for (const auto i : shown) {
    map.points.push_back(length.factor * positions[3 * i]);
    map.points.push_back(length.factor * positions[3 * i + 1]);
    held.push_back(all_held[i]);
    const auto material = static_cast<std::size_t>(std::max(0, result.material[i]));
    map.greys.push_back(result.material_types[material] == "wall" ? grey_of_walls : grey_of_others);
  }
  map.window = window_of(result, map.points, held, length.factor);
  map.reach = 1.2 * length.factor * result.spacing;
  const auto name = field.name == "velocity" ? "speed" : components > 1 ? "|" + field.name + "|" : field.name;
  const auto when = time_text(result.times[time]) + (result.dimension == 3 ? ", middle plane" : "");
  map.panels.push_back(make_panel(fmt::format("{}: {}, {}", name, ensemble_text(result, field), when), name, unit,
                                  picked(magnitudes(slice.mean, components), shown, all_held)));
  if (!slice.deviation.empty()) {
    map.panels.push_back(make_panel(fmt::format("{}: standard deviation over the realisations, {}", name, when),
                                    "deviation of " + name, unit,
                                    picked(magnitudes(slice.deviation, components), shown, all_held)));
  }
  if (options.arrows && components > 1) map.arrows = arrows_of(map, slice.mean, components, shown, all_held);
  if (result.axisymmetric) add_mirror_image(map);
  draw_map(map, result.title, png);
}

}  // namespace shmoo::run
