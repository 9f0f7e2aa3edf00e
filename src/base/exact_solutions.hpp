#pragma once
// Exact solutions by name, against which studies and tests measure. One list: name, what it is a solution of, its
// parameters with their dimensions, its formula with the source.
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "base/units.hpp"

namespace shmoo::base {

struct ExactSolution {
  struct Parameter {
    std::string_view name;
    Dimension dimension;
  };
  using Point = std::array<double, 3>;  // [m]

  std::string_view name, doc;
  Dimension dimension;  // of its value
  std::vector<Parameter> parameters;
  double (*value)(const Point& x, double t, std::span<const double> parameters);  // SI, parameters in their order
};

const std::vector<ExactSolution>& exact_solutions();
const ExactSolution* find_exact_solution(std::string_view name);  // null where there is none

}  // namespace shmoo::base
