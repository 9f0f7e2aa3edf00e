#pragma once
// Physical quantities as text, read once at the door: "347 um^2/s", "10 nM", "2000 molecules". UDUNITS-2 knows the units;
// M (mol/L) with its prefixes, P (poise) and an exact molecule (1 mol = 6.02214076e23 molecules) are defined on top.
#include <stdexcept>
#include <string>
#include <string_view>

namespace shmoo::base {

// Exponents of a quantity's dimension. Angles are pure numbers. An amount is counted in molecules.
struct Dimension {
  int length = 0, mass = 0, time = 0, temperature = 0, amount = 0, current = 0, luminosity = 0;
  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
  return {a.length + b.length,           a.mass + b.mass,     a.time + b.time,
          a.temperature + b.temperature, a.amount + b.amount, a.current + b.current,
          a.luminosity + b.luminosity};
}

constexpr Dimension power(const Dimension& a, int n) {
  return {a.length * n, a.mass * n, a.time * n, a.temperature * n, a.amount * n, a.current * n, a.luminosity * n};
}

constexpr Dimension operator/(const Dimension& a, const Dimension& b) { return a * power(b, -1); }

namespace dimensions {
inline constexpr Dimension none{};
inline constexpr Dimension length{.length = 1};
inline constexpr Dimension mass{.mass = 1};
inline constexpr Dimension time{.time = 1};
inline constexpr Dimension temperature{.temperature = 1};
inline constexpr Dimension amount{.amount = 1};
inline constexpr Dimension area = power(length, 2);
inline constexpr Dimension volume = power(length, 3);
inline constexpr Dimension speed = length / time;
inline constexpr Dimension acceleration = speed / time;
inline constexpr Dimension frequency = power(time, -1);
inline constexpr Dimension density = mass / volume;
inline constexpr Dimension energy = mass * power(speed, 2);
inline constexpr Dimension pressure = energy / volume;
inline constexpr Dimension viscosity = pressure * time;
inline constexpr Dimension diffusivity = area / time;
inline constexpr Dimension concentration = amount / volume;
inline constexpr Dimension flux = amount / (area * time);

// Of the rate constant of a reaction of order m: v = k prod C^nu with v in molecules/(m^3 s).
constexpr Dimension rate_constant(int order) { return power(concentration, 1 - order) / time; }
}  // namespace dimensions

// SI symbols, such as "m^2/s" or "m^3/(molecule s)"; "1" for a pure number.
std::string si_unit(const Dimension& dimension);

// What to write for such a quantity: "a length [m], such as \"1 um\"". Unnamed dimensions: "a quantity in kg/K".
std::string expectation(const Dimension& dimension);

// A name with its article and unit for what came: "a length [m]"; unnamed dimensions: "a quantity in kg/K".
std::string dimension_name(const Dimension& dimension);

struct Measured {
  double value = 0;  // SI, amounts in molecules
  Dimension dimension;
};

// The text is no quantity; what() says why, beginning with the offending part.
class QuantityError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Reads a decimal number followed by a unit. Throws QuantityError for anything else: no number, no unit, an unknown
// unit, a value that is not finite in SI. Safe to call from several threads (UDUNITS itself is not; a lock guards it).
Measured parse_quantity(std::string_view text);

}  // namespace shmoo::base
