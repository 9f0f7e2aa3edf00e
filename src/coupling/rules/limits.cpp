#include "coupling/rules/limits.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace shmoo::coupling {

const char* word(Standing standing) {
  switch (standing) {
    case Standing::ok:
      return "ok";
    case Standing::warn:
      return "warn";
    default:
      return "refuse";
  }
}

std::vector<Limit> judge_limits(const scene::Scene& scene, const Numbers& numbers, const Pace& pace) {
  std::vector<Limit> limits;
  if (scene.effects.flow) judge_flow_limits(scene, numbers, limits);
  judge_chemistry_limits(scene, numbers, limits);
  judge_run_limits(scene, numbers, pace, limits);
  return limits;
}

void enforce(const scene::Scene& scene, const std::vector<Limit>& limits) {
  if (scene.numerics.limits == scene::Limits::warn) return;
  std::vector<base::Diagnostic> mistakes;
  for (const auto& limit : limits) {
    if (limit.standing() != Standing::refuse) continue;
    mistakes.push_back(
        {{scene.file, 0, 0},
         fmt::format("{} is {:.3g}: {}. Up to {:.3g} is well, up to {:.3g} is run; {}, or run it all the "
                     "same with numerics.limits = \"warn\"",
                     limit.name, limit.value, limit.meaning, limit.ok, limit.refuse, limit.suggestion)});
  }
  if (!mistakes.empty()) throw base::InputError(std::move(mistakes));
}

}  // namespace shmoo::coupling
