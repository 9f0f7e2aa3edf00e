#pragma once
#include <string>

namespace shmoo::scene {

// A number or an expression. Expressions see x, y, z [m], t [s], every parameter (SI) and, in rate laws, every species by
// name as a concentration [molecules/m^3].
struct Quantity {
  double value = 0;        // SI
  std::string expression;  // used where not empty
};

}  // namespace shmoo::scene
