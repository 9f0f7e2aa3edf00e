#include "rdme/expression.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "rdme/network.hpp"
#include "rdme/state.hpp"

namespace shmoo::rdme {
namespace {

std::vector<std::string> all_names(const ExpressionNames& names) {
  std::vector<std::string> all{"x", "y", "z", "t"};  // the first three only where nothing else has their names
  for (const auto& [name, value] : names.parameters) all.push_back(name);
  for (const std::string& name : names.species) {
    if (scene::is_identifier(name)) all.push_back(name);
  }
  for (auto axis = all.begin(); axis != all.begin() + 3; ++axis)
    if (std::count(all.begin(), all.end(), *axis) > 1) *axis = "place_" + *axis;
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

std::optional<double> Expression::constant() const {
  for (std::size_t place = 0; place < 4; ++place)
    if (formula_.uses(place)) return std::nullopt;
  return reads_.empty() ? std::optional(value()) : std::nullopt;
}

double value_at(Expression& formula, const Network& network, const State& state, double t) {
  formula.set_time(t);
  for (const int s : formula.reads()) {
    const auto at = static_cast<std::size_t>(s);
    formula.set_concentration(s, network.stochastic(s) ? static_cast<double>(state.count[at]) : state.amount[at]);
  }
  for (std::size_t v = 0; v < state.parameter.size(); ++v)
    formula.set_parameter(static_cast<std::size_t>(network.varying()[v]), state.parameter[v]);
  return formula.value();
}

void Expression::set_position(double x, double y, double z) {
  values_[0] = x;
  values_[1] = y;
  values_[2] = z;
}

}  // namespace shmoo::rdme
