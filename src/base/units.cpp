#include "base/units.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <mutex>
#include <vector>

#include "base/constants.hpp"

namespace shmoo::base {
namespace {

constexpr std::size_t longest_quantity = 200;  // characters

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

// What a visit of a parsed unit finds: its dimension and the SI unit it is a multiple of.
struct Found {
  Dimension dimension;
  double molecules = 1;  // molecules per amount unit of the SI unit
  const ut_unit* si = nullptr;
  bool linear = true;  // neither a time stamp nor a logarithm
};

void add_basic(Found& found, const ut_unit* basic, int power) {
  const char* given = ut_get_name(basic, UT_ASCII);
  const std::string_view name = given ? given : "";
  if (name == "meter")
    found.dimension.length += power;
  else if (name == "kilogram")
    found.dimension.mass += power;
  else if (name == "second")
    found.dimension.time += power;
  else if (name == "kelvin")
    found.dimension.temperature += power;
  else if (name == "ampere")
    found.dimension.current += power;
  else if (name == "candela")
    found.dimension.luminosity += power;
  else if (name == "molecule")
    found.dimension.amount += power;
  else if (name == "mole") {  // of units such as the katal that the database builds on its own mole
    found.dimension.amount += power;
    found.molecules *= std::pow(avogadro, power);
  }
}

ut_status visit_basic(const ut_unit* unit, void* found) {
  add_basic(*static_cast<Found*>(found), unit, 1);
  static_cast<Found*>(found)->si = unit;
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit* unit, int count, const ut_unit* const* basics, const int* powers, void* found) {
  for (int i = 0; i < count; ++i) add_basic(*static_cast<Found*>(found), basics[i], powers[i]);
  static_cast<Found*>(found)->si = unit;
  return UT_SUCCESS;
}

ut_status visit_galilean(const ut_unit*, double, const ut_unit* underlying, double, void* found);

ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* found) {
  static_cast<Found*>(found)->linear = false;
  return UT_SUCCESS;
}

ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* found) {
  static_cast<Found*>(found)->linear = false;
  return UT_SUCCESS;
}

constexpr ut_visitor visitor{visit_basic, visit_product, visit_galilean, visit_timestamp, visit_logarithmic};

ut_status visit_galilean(const ut_unit*, double, const ut_unit* underlying, double, void* found) {
  return ut_accept_visitor(underlying, &visitor, found);
}

void rename(ut_system* system, const char* name, const ut_unit* unit) {
  ut_unmap_name_to_unit(system, name, UT_ASCII);
  ut_map_name_to_unit(name, UT_ASCII, unit);
}

// The unit database, with amounts based on the molecule. Lives as long as the program.
class UnitSystem {
 public:
  UnitSystem() {
    ut_set_error_message_handler(ut_ignore);
    system_ = ut_read_xml(nullptr);
    if (!system_) throw std::runtime_error("the unit database of UDUNITS-2 cannot be read; install libudunits2-data");
    molecule_.reset(ut_new_base_unit(system_));
    for (const char* name : {"molecule", "molecules", "molec", "molecs"}) rename(system_, name, molecule_.get());
    ut_map_unit_to_name(molecule_.get(), "molecule", UT_ASCII);
    mole_.reset(ut_scale(avogadro, molecule_.get()));
    for (const char* name : {"mole", "moles"}) rename(system_, name, mole_.get());
    ut_unmap_symbol_to_unit(system_, "mol", UT_ASCII);
    ut_map_symbol_to_unit("mol", UT_ASCII, mole_.get());
    const Unit per_cubic_metre(ut_parse(system_, "m^-3", UT_ASCII));
    const Unit molecules(ut_multiply(molecule_.get(), per_cubic_metre.get()));
    molar_.reset(ut_scale(1000 * avogadro, molecules.get()));
    ut_map_symbol_to_unit("M", UT_ASCII, molar_.get());
    poise_.reset(ut_parse(system_, "0.1 Pa s", UT_ASCII));
    ut_map_symbol_to_unit("P", UT_ASCII, poise_.get());  // for cP; the database knows the name only
    ut_map_name_to_unit("molar", UT_ASCII, molar_.get());
  }

  Unit parse(const std::string& text) const { return Unit(ut_parse(system_, text.c_str(), UT_UTF8)); }

 private:
  ut_system* system_ = nullptr;
  Unit molecule_, mole_, molar_, poise_;
};

Measured in_si(double number, const std::string& unit_text) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  static const auto* const units = new UnitSystem;  // never freed: other statics may still parse at exit
  const Unit unit = units->parse(unit_text);
  if (!unit) throw QuantityError(fmt::format("'{}' is not a unit", unit_text));
  Found found;
  found.si = unit.get();
  ut_accept_visitor(unit.get(), &visitor, &found);
  if (!found.linear) throw QuantityError(fmt::format("'{}' is not a unit of measure", unit_text));
  const Converter converter(ut_get_converter(unit.get(), const_cast<ut_unit*>(found.si)));
  if (!converter) throw QuantityError(fmt::format("'{}' is not a unit of measure", unit_text));
  const double value = cv_convert_double(converter.get(), number) * found.molecules;
  if (!std::isfinite(value)) throw QuantityError("the value is not finite in SI units");
  if (value == 0 && number != 0) throw QuantityError("the value is too small to be held in SI units");
  return {value, found.dimension};
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blank = " \t";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

// UDUNITS skips some bytes that it does not know, so only characters that units are made of pass.
bool made_of_unit_characters(std::string_view text) {
  constexpr std::array<std::string_view, 8> beyond_ascii{"\u00b5", "\u03bc", "\u00b0", "\u00c5",
                                                         "\u03a9", "\u00b2", "\u00b3", "\u00b7"};
  while (!text.empty()) {
    if (text.front() >= ' ' && text.front() <= '~') {
      text.remove_prefix(1);
      continue;
    }
    const auto known = std::find_if(beyond_ascii.begin(), beyond_ascii.end(),
                                    [&](std::string_view character) { return text.starts_with(character); });
    if (known == beyond_ascii.end()) return false;
    text.remove_prefix(known->size());
  }
  return true;
}

}  // namespace

Measured parse_quantity(std::string_view text) {
  if (text.size() > longest_quantity) throw QuantityError("the text is too long for a quantity");
  text = trim(text);
  std::string_view digits = text;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double number = 0;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (status == std::errc::result_out_of_range) throw QuantityError("the number is too large or too small");
  if (status != std::errc{} || (digits.size() != text.size() && digits.starts_with('-')))
    throw QuantityError("there is no number at its beginning");
  if (!std::isfinite(number)) throw QuantityError("the number is not finite");
  const std::string unit(trim(digits.substr(static_cast<std::size_t>(end - digits.data()))));
  if (unit.empty()) throw QuantityError("the number has no unit");
  if (!made_of_unit_characters(unit)) throw QuantityError("the unit holds characters that no unit is made of");
  const bool reciprocal = unit.starts_with("1/") || unit.starts_with("1 /");
  if (!reciprocal && std::string_view("0123456789.+-*/^@").find(unit.front()) != std::string_view::npos)
    throw QuantityError(fmt::format("'{}' is not a unit", unit));
  return in_si(number, unit);
}

}  // namespace shmoo::base
