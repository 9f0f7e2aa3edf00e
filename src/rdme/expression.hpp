#pragma once
// A formula over species concentrations, parameters, position and time, bound to its values. One object per sampler,
// solver and thread.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/expression.hpp"

namespace shmoo::rdme {

// Names that an expression may read besides x, y, z [m] and t [s]: parameters (constants, SI) and species (by index;
// those whose name is no identifier cannot be read).
struct ExpressionNames {
  std::vector<std::pair<std::string, double>> parameters;
  std::vector<std::string> species;
};

class Expression {
 public:
  // Throws base::InputError: what is wrong with the text.
  Expression(const std::string& text, const ExpressionNames& names);

  const std::vector<int>& reads() const { return reads_; }  // species, ascending
  bool reads_time() const { return reads_time_; }
  bool reads_place() const { return reads_place_; }
  bool reads_parameter(std::size_t which) const { return formula_.uses(4 + which); }  // by its place among the names
  std::optional<double> constant() const;  // its value, where it reads nothing but parameters

  // Set what is read, then take the value. Concentrations in [molecules/m^3], by species.
  void set_concentration(int species, double value) { values_[place_[species]] = value; }
  void set_position(double x, double y, double z);  // [m]
  void set_time(double t) { values_[3] = t; }       // [s]
  void set_parameter(std::size_t which, double value) { values_[4 + which] = value; }
  double time() const { return values_[3]; }
  double value() const { return formula_(values_); }

 private:
  std::vector<double> values_;      // x, y, z, t, parameters, species
  std::vector<std::size_t> place_;  // by species
  scene::Expression formula_;
  std::vector<int> reads_;
  bool reads_time_ = false, reads_place_ = false;
};

class Network;
struct State;

// The value of a formula of numbers in a well: species by their molecules, parameters as the state has them. t [s].
double value_at(Expression& formula, const Network& network, const State& state, double t);

}  // namespace shmoo::rdme
