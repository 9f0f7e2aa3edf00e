#include "run/verify/case.hpp"

namespace shmoo::run::verify {

std::vector<Case> stability_cases() {
  std::vector<Case> all;
  for (auto part : {hard_starts(), hard_flows(), hard_walls(), hard_shots(), hard_openings(), hard_solids(),
                    hard_shells(), hard_chemistry(), hard_rates(), hard_splittings()}) {
    for (auto& one : part) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace shmoo::run::verify
