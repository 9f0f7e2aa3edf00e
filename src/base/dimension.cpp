// How dimensions are spoken of in messages.
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include "base/units.hpp"

namespace shmoo::base {
namespace {

struct Named {
  Dimension dimension;
  std::string_view name;
  std::string_view example;
};

using namespace dimensions;

constexpr std::array names{
    Named{none, "a pure number", "0.5"},
    Named{length, "a length", "1 um"},
    Named{area, "an area", "1 um^2"},
    Named{volume, "a volume", "1 um^3"},
    Named{dimensions::time, "a time", "1 s"},
    Named{mass, "a mass", "1 pg"},
    Named{temperature, "a temperature", "300 K"},
    Named{amount, "a number of molecules", "2000 molecules"},
    Named{speed, "a speed", "1 um/s"},
    Named{acceleration, "an acceleration", "9.81 m/s^2"},
    Named{frequency, "a frequency", "1 1/s"},
    Named{density, "a mass density", "1000 kg/m^3"},
    Named{energy, "an energy", "4.14e-21 J"},
    Named{pressure, "a pressure", "1 Pa"},
    Named{viscosity, "a dynamic viscosity", "1e-3 Pa s"},
    Named{diffusivity, "a diffusivity", "100 um^2/s"},
    Named{concentration, "a concentration", "10 nM"},
    Named{flux, "a flux of molecules", "1 molecules/(um^2 s)"},
    Named{rate_constant(0), "a rate of production", "1 nM/s"},
    Named{rate_constant(2), "a second-order rate constant", "1e6 1/(M s)"},
    Named{rate_constant(3), "a third-order rate constant", "1e12 1/(M^2 s)"},
};

const Named* find(const Dimension& dimension) {
  for (const Named& named : names)
    if (named.dimension == dimension) return &named;
  return nullptr;
}

std::string factor(std::string_view symbol, int exponent) {
  return exponent == 1 ? std::string(symbol) : fmt::format("{}^{}", symbol, exponent);
}

std::string product(const std::vector<std::string>& factors) { return fmt::format("{}", fmt::join(factors, " ")); }

}  // namespace

std::string si_unit(const Dimension& d) {
  const std::array<std::pair<std::string_view, int>, 7> exponents{{{"molecule", d.amount},
                                                                   {"kg", d.mass},
                                                                   {"m", d.length},
                                                                   {"s", d.time},
                                                                   {"K", d.temperature},
                                                                   {"A", d.current},
                                                                   {"cd", d.luminosity}}};
  std::vector<std::string> above, below;
  for (const auto& [symbol, exponent] : exponents) {
    if (exponent > 0) above.push_back(factor(symbol, exponent));
    if (exponent < 0) below.push_back(factor(symbol, -exponent));
  }
  if (below.empty()) return above.empty() ? "1" : product(above);
  const std::string denominator = below.size() == 1 ? below.front() : fmt::format("({})", product(below));
  return fmt::format("{}/{}", above.empty() ? "1" : product(above), denominator);
}

std::string expectation(const Dimension& dimension) {
  if (const Named* named = find(dimension))
    return fmt::format("{}, such as \"{}\"", dimension_name(dimension), named->example);
  return fmt::format("a quantity in {}", si_unit(dimension));
}

std::string dimension_name(const Dimension& dimension) {
  if (dimension == none) return "a pure number";
  if (const Named* named = find(dimension)) return fmt::format("{} [{}]", named->name, si_unit(dimension));
  return fmt::format("a quantity in {}", si_unit(dimension));
}

}  // namespace shmoo::base
