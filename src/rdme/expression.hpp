#pragma once
// Expressions over species concentrations, parameters, position and time, compiled once and evaluated many times
// (muParser). An object is not thread safe: each sampler, solver and thread holds its own.
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace mu {
class Parser;
}

namespace shmoo::rdme {

// Names an expression may read besides x, y, z [m] and t [s]: parameters (constants, SI) and species (by index).
struct ExpressionNames {
  std::vector<std::pair<std::string, double>> parameters;
  std::vector<std::string> species;
};

class Expression {
 public:
  // Throws base::InputError: what is wrong with the text and where in it.
  Expression(const std::string& text, const ExpressionNames& names);
  ~Expression();
  Expression(Expression&&) noexcept;
  Expression& operator=(Expression&&) noexcept;

  const std::vector<int>& reads() const { return reads_; }  // species, ascending
  bool reads_time() const { return reads_time_; }

  // Set what is read, then take the value. Concentrations in [molecules/m^3], by species.
  void set_concentration(int species, double value) { variables_[4 + species] = value; }
  void set_position(double x, double y, double z);  // [m]
  void set_time(double t) { variables_[3] = t; }    // [s]
  double time() const { return variables_[3]; }
  double value() const;

 private:
  std::unique_ptr<mu::Parser> parser_;
  std::vector<double> variables_;  // x, y, z, t, then one per species; never resized, the parser points into it
  std::vector<int> reads_;
  bool reads_time_ = false;
};

}  // namespace shmoo::rdme
