#include "run/plot/style.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "run/plot/gnuplot.hpp"

namespace shmoo::run {
namespace {

constexpr std::array<Colour, 11> anchors = {{{0x44, 0x01, 0x54},
                                             {0x48, 0x24, 0x75},
                                             {0x41, 0x44, 0x87},
                                             {0x35, 0x5f, 0x8d},
                                             {0x2a, 0x78, 0x8e},
                                             {0x21, 0x91, 0x8c},
                                             {0x22, 0xa8, 0x84},
                                             {0x44, 0xbf, 0x70},
                                             {0x7a, 0xd1, 0x51},
                                             {0xbd, 0xdf, 0x26},
                                             {0xfd, 0xe7, 0x25}}};

// Powers of a length inside units: what a metre's prefix does to each.
const std::map<std::string, int> length_units = {
    {"m", 1}, {"m/s", 1}, {"m^2", 2}, {"m^3", 3}, {"m^2/s", 2}, {"molecules/m^3", -3}, {"1/m^3", -3}};

std::string power_text(const std::string& unit, const std::string& length) {
  if (unit == "m") return length;
  if (unit == "m/s") return length + "/s";
  if (unit == "m^2") return length + "²";
  if (unit == "m^2/s") return length + "²/s";
  if (unit == "m^3") return length + "³";
  return unit.substr(0, unit.find('/')) + "/" + length + "³";
}

// "10^6 molecules" for numbers too large or too small to be read.
Reading with_power_of_ten(const std::string& unit, double magnitude) {
  if (magnitude >= 1e-2 && magnitude < 1e5) return {1.0, unit};
  const int power = 3 * static_cast<int>(std::floor(std::log10(magnitude) / 3));
  const auto text = power_of_ten(power);
  return {std::pow(10.0, -power), unit.empty() || unit == "1" ? text : text + " " + unit};
}

}  // namespace

Colour viridis(double x) {
  const double at = std::clamp(std::isfinite(x) ? x : 0.0, 0.0, 1.0) * (anchors.size() - 1);
  const auto i = std::min<std::size_t>(anchors.size() - 2, static_cast<std::size_t>(at));
  const double part = at - static_cast<double>(i);
  Colour out{};
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = static_cast<std::uint8_t>(std::lround((1 - part) * anchors[i][c] + part * anchors[i + 1][c]));
  return out;
}

std::string viridis_palette() {
  std::string list;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    list +=
        fmt::format("{}{} '#{:02x}{:02x}{:02x}'", i == 0 ? "" : ", ", i, anchors[i][0], anchors[i][1], anchors[i][2]);
  }
  return "set palette defined (" + list + ")\n";
}

Reading readable(const std::string& unit, double magnitude) {
  struct Prefix {
    double factor;
    const char* text;
  };
  static constexpr std::array<Prefix, 6> prefixes = {
      {{1.0, ""}, {1e3, "m"}, {1e6, "µ"}, {1e9, "n"}, {1e12, "p"}, {1e15, "f"}}};
  if (!(magnitude > 0)) return {1.0, unit};
  if (const auto found = length_units.find(unit); found != length_units.end()) {
    const int power = found->second;
    // Lengths keep to m, mm, um, nm; the first that gives numbers of at least 1 (at most 1e4 for densities).
    for (std::size_t p = 0; p < 4; ++p) {
      const double factor = std::pow(prefixes[p].factor, power);
      const double shown = magnitude * factor;
      if ((power > 0 && shown >= 1.0) || (power < 0 && shown < 1e4))
        return {factor, power_text(unit, std::string(prefixes[p].text) + "m")};
    }
  }
  if (unit == "s" || unit == "J" || unit == "Pa") {
    for (const auto& prefix : prefixes) {
      if (magnitude * prefix.factor >= 1.0 && magnitude * prefix.factor < 1e5)
        return {prefix.factor, prefix.text + unit};
    }
  }
  return with_power_of_ten(unit, magnitude);
}

std::string power_of_ten(int power) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = power < 0 ? "10⁻" : "10";
  for (const char c : std::to_string(std::abs(power))) text += digits[static_cast<std::size_t>(c - '0')];
  return text;
}

std::string with_unit(const std::string& name, const std::string& unit) {
  return unit.empty() || unit == "1" ? name : fmt::format("{} ({})", name, unit);
}

std::string time_text(double seconds) {
  const auto reading = readable("s", seconds);
  return fmt::format("t = {:.4g} {}", seconds * reading.factor, reading.unit);
}

Range range_of(std::span<const double> values, bool from_zero) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto value : values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  if (range.low > range.high) return {0, 1};
  if (from_zero && range.low > 0) range.low = 0;
  // A span at the level of rounding shows as constant.
  if (range.high - range.low <= 1e-9 * std::max(std::abs(range.low), std::abs(range.high))) {
    const double margin = range.high == 0 ? 1.0 : 0.05 * std::abs(range.high);
    return {from_zero && range.low >= 0 ? 0 : range.low - margin, range.high + margin};
  }
  return range;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (auto& value : values) value *= factor;
  return values;
}

double largest_magnitude(std::span<const double> values) {
  double largest = 0;
  for (const auto value : values) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

std::string axes_style() {
  return "set border 3 lw 0.8 lc rgb '#555555'\nset tics out nomirror scale 0.6 textcolor rgb '#333333'\n"
         "set xlabel textcolor rgb '#333333'\nset ylabel textcolor rgb '#333333'\n";
}

std::string curve_style(const std::string& heading, const std::string& title) {
  auto script = axes_style();
  script +=
      fmt::format("set label 1 {} at screen 0.016,0.965 left font ',13' textcolor rgb '#111111'\n", quoted(heading));
  script +=
      fmt::format("set label 2 {} at screen 0.016,0.915 left font ',11' textcolor rgb '#444444'\n", quoted(title));
  return script +
         "set tmargin at screen 0.82\nset bmargin at screen 0.12\nset lmargin at screen 0.115\nset rmargin at screen "
         "0.97\n"
         "set key at screen 0.97,0.875 right center horizontal maxrows 1 samplen 2 font ',10' textcolor rgb '#333333'\n"
         "set autoscale xfix\nset grid back lw 0.5 lc rgb '#e6e6e6'\n";
}

}  // namespace shmoo::run
