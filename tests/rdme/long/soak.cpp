// More than 10^10 events in one run: the ledger accounts for every molecule, and the law still holds.
#include <fmt/core.h>

#include "../trial.hpp"

namespace shmoo::rdme {
namespace {

TEST(Soak, TheLedgerIsExactOverTenBillionEvents) {
  scene::Scene scene = water();
  const int a = add_species(scene, "A", 1.0), b = add_species(scene, "B", 1.0), c = add_species(scene, "C", 1.0);
  add_reaction(scene, "binding", {{a, 1}, {b, 1}}, {{c, 1}}, 0.09);
  add_reaction(scene, "unbinding", {{c, 1}}, {{a, 1}, {b, 1}}, 0.9);
  constexpr std::uint32_t n = 40;
  Trial trial(scene::Sampler::split, scene, lattice({n, n, n}, true, 1.0, 3));
  for (const int species : {a, b, c}) fill(trial.state, species, 10);
  trial.begin();
  const auto events = [&] { return trial.state.reaction_events + trial.state.jump_events; };
  for (double until = 5.0; events() < 10'000'000'000; until += 5.0) trial.run(until, 0.5);  // looks at the ledger
  const double total = double(n) * n * n * 20;
  EXPECT_EQ(total_count(trial.state, a) + total_count(trial.state, c), std::int64_t(total));
  EXPECT_EQ(total_count(trial.state, b) + total_count(trial.state, c), std::int64_t(total));
  fmt::print("{} events, {} of them reactions, to t = {}\n", events(), trial.state.reaction_events, trial.t);
}

}  // namespace
}  // namespace shmoo::rdme
