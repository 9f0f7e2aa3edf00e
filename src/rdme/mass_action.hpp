#pragma once
// Formulas that are mass action in disguise, so that they need not be read as formulas at every event.
#include <optional>
#include <string>
#include <vector>

#include "rdme/network.hpp"

namespace shmoo::rdme {

struct MassAction {
  double constant = 0;                 // c >= 0
  std::vector<scene::Term> reactants;  // merged by species, ascending
};

// The formula of numbers n as c prod n (n - 1) ... (n - nu + 1), where it is just that, however it is written:
// "k*A*B/cell", "k*X*(X - 1)/2". `fixed`: parameters that never change.
std::optional<MassAction> as_mass_action(const std::string& formula, const std::vector<std::string>& species,
                                         const std::vector<std::pair<std::string, double>>& fixed);

}  // namespace shmoo::rdme
