#pragma once
// Short words to write the schema's tables with.
#include <utility>

#include "scene/schema.hpp"

namespace shmoo::scene::forms {

using base::Dimension;
namespace dimensions = base::dimensions;

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr Range any{};
inline constexpr Range positive{0, infinite, true, false};
inline constexpr Range not_negative{0, infinite, false, false};

inline Form boolean() { return {Kind::boolean}; }
inline Form integer(double lower, double upper) { return {.kind = Kind::integer, .range = {lower, upper}}; }
inline Form number(Range range) { return {.kind = Kind::number, .range = range}; }
inline Form text(std::string_view what) { return {.kind = Kind::text, .what = what}; }
inline Form choice(std::vector<std::string_view> names) { return {.kind = Kind::choice, .choices = std::move(names)}; }
inline Form quantity(Dimension dimension, Range range) {
  return {.kind = Kind::quantity, .dimension = dimension, .range = range};
}
inline Form unit_later(std::string_view what, Range range = any) {
  return {.kind = Kind::unit_later, .range = range, .what = what};
}
inline Form expression(std::string_view what) { return {.kind = Kind::expression, .what = what}; }
inline Form list(std::vector<Form> element, std::size_t least = 0,
                 std::size_t most = std::numeric_limits<std::size_t>::max()) {
  return {.kind = Kind::list, .element = std::move(element), .least = least, .most = most};
}
inline Form per_axis(std::vector<Form> element) {
  return {.kind = Kind::list, .element = std::move(element), .per_axis = true};
}
inline Form subtable(std::string_view id) { return {.kind = Kind::table, .table = id}; }
inline Form named(std::vector<Form> element, std::string_view what) {
  return {.kind = Kind::named, .element = std::move(element), .what = what};
}
inline Form refused() { return {Kind::refused}; }

inline Form position() { return per_axis({quantity(dimensions::length, any)}); }
inline Form velocity() { return per_axis({quantity(dimensions::speed, any)}); }
inline std::vector<Form> one_or_more(std::string_view what) { return {text(what), list({text(what)}, 1)}; }

}  // namespace shmoo::scene::forms
