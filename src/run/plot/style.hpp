#pragma once
// What all pictures share: colours, units fit for reading, text.
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace shmoo::run {

using Colour = std::array<std::uint8_t, 3>;

// Viridis (van der Walt and Smith 2015): even steps look even, also in grey and to colour-blind eyes. x in [0, 1].
Colour viridis(double x);
std::string viridis_palette();  // gnuplot's "set palette" of the same

inline constexpr const char* main_colour = "#1f6f8b";
inline constexpr const char* accent_colour = "#d1495b";
inline constexpr const char* faint_colour = "#9aa5ab";

// A unit with the prefix that suits a magnitude: multiply by factor and write `unit`.
struct Reading {
  double factor = 1.0;
  std::string unit;
};
Reading readable(const std::string& unit, double magnitude);

std::string with_unit(const std::string& name, const std::string& unit);  // "x (um)", or the name alone
std::string power_of_ten(int power);                                      // "10⁻³"
std::string time_text(double seconds);                                    // "t = 0.8 s", "t = 20 ms"

struct Range {
  double low = 0, high = 1;
};
// Of all finite values; widened where it is empty; from 0 where all are >= 0 and `from_zero`.
Range range_of(std::span<const double> values, bool from_zero);

std::vector<double> scaled(std::vector<double> values, double factor);
double largest_magnitude(std::span<const double> values);  // of the finite ones

// Script lines for axes in a quiet style.
std::string axes_style();

// The same with the margins, heading and key that all pictures of curves share, on a canvas of this size.
inline constexpr int curve_width = 900, curve_height = 560;  // [pixels]
std::string curve_style(const std::string& heading, const std::string& title);

}  // namespace shmoo::run
