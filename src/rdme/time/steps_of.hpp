#pragma once
// Where a formula may jump as one of its variables changes: at its comparisons and at what rounds.
#include <string>
#include <vector>

namespace shmoo::rdme {

struct StepSource {
  std::string level;     // a part of the formula that is constant between steps
  std::string distance;  // a smooth formula that is zero where the level steps
};

// Of a formula that has been compiled: parentheses match.
std::vector<StepSource> steps_of(const std::string& formula);

}  // namespace shmoo::rdme
