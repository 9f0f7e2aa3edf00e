#include "coupling/rules/judgement.hpp"

#include <fmt/format.h>

#include "coupling/rules/decide.hpp"
#include "coupling/rules/limits.hpp"

namespace shmoo::coupling {

Judgement judge(scene::Scene scene) {
  auto decided = decide(std::move(scene));
  Judgement judgement{.scene = std::move(decided.scene)};
  for (const auto& one : decided.numbers.species) judgement.reference.push_back(one.reference);
  for (const auto& decision : decided.decisions) {
    if (!decision.automatic) continue;
    judgement.notes.push_back(line(decision));
    const bool yes = decision.value == "on" || decision.value == "stochastic";
    judgement.derived.push_back({decision.key, yes ? 1.0 : 0.0, "1", line(decision)});
  }
  const auto limits = judge_limits(judgement.scene, decided.numbers);
  enforce(judgement.scene, limits);
  for (const auto& limit : limits) {
    if (limit.standing() == Standing::ok) continue;
    const auto why = fmt::format("WARNING: above {:g}; {}; {}", limit.ok, limit.meaning, limit.suggestion);
    judgement.notes.push_back(fmt::format("{} = {:.3g}: {}", limit.name, limit.value, why));
    judgement.derived.push_back({limit.name, limit.value, "1", why});
  }
  return judgement;
}

}  // namespace shmoo::coupling
