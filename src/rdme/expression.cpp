#include "rdme/expression.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace shmoo::rdme {
namespace {

std::vector<std::string> all_names(const ExpressionNames& names) {
  std::vector<std::string> all{"x", "y", "z", "t"};
  for (const auto& [name, value] : names.parameters) all.push_back(name);
  for (const std::string& name : names.species) {
    if (scene::is_identifier(name)) all.push_back(name);
  }
  return all;
}

scene::Expression compile(const std::string& text, const ExpressionNames& names) {
  try {
    return {text, all_names(names)};
  } catch (const scene::ExpressionError& error) {
    throw base::InputError(fmt::format("the expression '{}' cannot be used: {}", text, error.what()));
  }
}

}  // namespace

Expression::Expression(const std::string& text, const ExpressionNames& names)
    : values_(4, 0.0), place_(names.species.size(), 0), formula_(compile(text, names)) {
  for (const auto& [name, value] : names.parameters) values_.push_back(value);
  for (std::size_t s = 0; s < names.species.size(); ++s) {
    if (!scene::is_identifier(names.species[s])) continue;
    place_[s] = values_.size();
    values_.push_back(0.0);
    if (formula_.uses(place_[s])) reads_.push_back(static_cast<int>(s));
  }
  reads_time_ = formula_.uses(3);
  reads_place_ = formula_.uses(0) || formula_.uses(1) || formula_.uses(2);
}

void Expression::set_position(double x, double y, double z) {
  values_[0] = x;
  values_[1] = y;
  values_[2] = z;
}

}  // namespace shmoo::rdme
