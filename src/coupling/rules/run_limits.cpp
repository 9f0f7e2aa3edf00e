// Runs that could never finish.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/rules/limits.hpp"
#include "coupling/rules/settling.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::coupling {
namespace {

constexpr double day = 86400.0, month = 30.0 * day;  // [s]

const char* whose(const Pace& pace) { return pace.measured ? "measured here" : "more than machines do"; }

Limit flow_time(const scene::Scene& scene, const Numbers& numbers, const Pace& pace) {
  const double settling = settling_time(scene, numbers), until = std::min(scene.run.until, settling);
  const double steps = until / numbers.flow.step;
  const double runs = scene.effects.thermal_noise ? scene.run.realisations : 1;
  const double seconds = runs * steps * double(numbers.particles) / pace.particle_steps;
  const double reachable = numbers.flow.step * pace.particle_steps * day / double(numbers.particles) / runs;
  const auto steady =
      std::isfinite(settling) ? "" : ", or give numerics.steady_tolerance where the flow becomes steady";
  return {"days of computing the flow",
          seconds / day,
          1.0,
          month / day,
          fmt::format("{:.3g} s at {:.3g} s a step ({}) are {:.3g} steps, x {} particles x {:g} runs at {:.2g} "
                      "particle-steps a second ({}) are {:.3g} days",
                      until, numbers.flow.step, numbers.flow.step_rule, steps, numbers.particles, runs,
                      pace.particle_steps, whose(pace), seconds / day),
          fmt::format("set run.until to at most {:.2g} s{}", reachable, steady),
          "arithmetic: time over step, times particles, over pace"};
}

Limit solid_time(const scene::Scene& scene, const Numbers& numbers, const Pace& pace) {
  const double steps = scene.run.until / numbers.solid_step;
  const double seconds = steps * double(numbers.voxels) / pace.particle_steps;
  return {
      "days of computing the solids",
      seconds / day,
      1.0,
      month / day,
      fmt::format("{:.3g} s at {:.3g} s a step (elastic waves) are {:.3g} steps, x {} particles at {:.2g} "
                  "particle-steps a second ({}) are {:.3g} days",
                  scene.run.until, numbers.solid_step, steps, numbers.voxels, pace.particle_steps, whose(pace),
                  seconds / day),
      fmt::format(
          "set run.until to at most {:.2g} s, or for a closed wall under turgor mechanics.motion to \"quasi-static\"",
          numbers.solid_step * pace.particle_steps * day / double(numbers.voxels)),
      "arithmetic: time over step, times particles, over pace"};
}

// Diffusive jumps on a lattice of nearest neighbours, 2 D kappa/h^2 a molecule, and reactions.
double event_rate(const scene::Scene& scene, const Numbers& numbers) {
  double rate = 0.0;  // [1/s]
  for (std::size_t s = 0; s < numbers.species.size(); ++s) {
    if (scene.species[s].method != scene::SpeciesMethod::stochastic) continue;
    const auto& one = numbers.species[s];
    const double jumps = 2.0 * numbers.dimension * one.diffusivity / (numbers.spacing * numbers.spacing);
    rate += std::max(one.start, one.per_voxel) * ((one.home > 1 ? jumps : 0.0) + one.turnover);
  }
  return rate;
}

Limit event_time(const scene::Scene& scene, const Numbers& numbers, const Pace& pace) {
  const double rate = event_rate(scene, numbers), events = rate * scene.run.until * scene.run.realisations;
  return {
      "days of drawing events",
      events / pace.events / day,
      1.0,
      month / day,
      fmt::format("{:.3g} events a second x {:.3g} s x {} realisations at {:.2g} events a second ({}) are {:.3g} days",
                  rate, scene.run.until, scene.run.realisations, pace.events, whose(pace), events / pace.events / day),
      "set numerics.sampler to \"split\", whose cost does not grow with the molecules",
      "arithmetic: events over pace"};
}

}  // namespace

void judge_run_limits(const scene::Scene& scene, const Numbers& numbers, const Pace& pace, std::vector<Limit>& limits) {
  if (scene.effects.flow && std::isfinite(numbers.flow.step)) limits.push_back(flow_time(scene, numbers, pace));
  if (std::isfinite(numbers.solid_step) && scene.mechanics.motion == scene::Motion::dynamic)
    limits.push_back(solid_time(scene, numbers, pace));
  if (!rdme::takes_turns(scene.numerics.sampler) && event_rate(scene, numbers) > 0.0)
    limits.push_back(event_time(scene, numbers, pace));
}

}  // namespace shmoo::coupling
