#pragma once
// Equations as chemists write them: "A + 2 B -> C", "R + L <-> RL", "0 -> A".
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace shmoo::scene {

class EquationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

using EquationSide = std::vector<std::pair<std::string, int>>;  // name and count as written; empty: nothing

struct Equation {
  EquationSide left, right;
  bool reversible = false;
};

// Counts are 1 to 1000. "0", "nothing" and "" stand for no species. Throws EquationError.
Equation parse_equation(std::string_view text);

}  // namespace shmoo::scene
