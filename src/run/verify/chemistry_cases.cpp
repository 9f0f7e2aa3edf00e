#include "run/verify/chemistry/experiment.hpp"

namespace shmoo::run::verify {

std::vector<Case> chemistry_cases(std::uint64_t seed) {
  std::vector<Case> cases;
  for (const auto& group : {reactions_alone(), walkers(), meetings()})
    for (const auto& [name, what, make] : group)
      cases.push_back({name, what, [make = make, seed] { return judge(make(), seed); }});
  cases.push_back({"min-oscillations", "MinD and MinE swing between the ends of a cell, on a coarse strip",
                   [seed] { return min_oscillations(seed); }});
  return cases;
}

}  // namespace shmoo::run::verify
