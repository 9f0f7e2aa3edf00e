#include "run/explain/rehearsal.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "coupling/rules/settling.hpp"
#include "rdme/sampler.hpp"
#include "run/explain/memory.hpp"
#include "run/recorder.hpp"

namespace shmoo::run {
namespace {

constexpr std::size_t moments_to_see = 8;
constexpr double part_for_flow = 0.4;  // of the budget; a longer flow is left out
constexpr double patience = 2;         // budgets
constexpr double finest = 256;         // parts into which a play is cut to see its course

// The velocity that drives the fluid, wherever it is driven.
scene::Point plug_velocity(const scene::Scene& scene, double speed) {
  for (const auto& inflow : scene.inflows)
    if (inflow.velocity) return *inflow.velocity;
  scene::Point velocity{};
  if (!scene.flow.body_force) return velocity;
  const auto& f = *scene.flow.body_force;
  const double size = std::hypot(f[0], f[1], f[2]);
  for (std::size_t a = 0; a < 3; ++a) velocity[a] = size > 0.0 ? speed * f[a] / size : 0.0;
  return velocity;
}

// The flow starts as it will be on the whole, and the first look, after a billionth of its time scales, calls it
// steady.
scene::Scene carried_from_the_start(scene::Scene scene, const coupling::FlowNumbers& flow) {
  const auto velocity = plug_velocity(scene, flow.speed);
  scene.flow.initial_velocity.clear();
  for (int a = 0; a < scene.dimension; ++a) scene.flow.initial_velocity.push_back({velocity[std::size_t(a)], ""});
  scene.flow.reference_speed = flow.speed;
  scene.flow.sound_speed = flow.sound_speed;
  scene.flow.reference_length = 1e-9 * flow.length;
  scene.numerics.steady_tolerance = 1.0;
  return scene;
}

bool only_sampled(const scene::Scene& scene) {
  return std::none_of(scene.species.begin(), scene.species.end(),
                      [](const auto& species) { return species.method != scene::SpeciesMethod::stochastic; });
}

}  // namespace

Play choose_play(const scene::Scene& scene, const coupling::Numbers& numbers, const coupling::FlowCosts* flow,
                 double budget) {
  Play play{Play::Kind::whole, scene};
  play.scene.numerics.limits = scene::Limits::warn;
  if (flow && !scene.effects.thermal_noise) {
    const double pace = flow->step / (flow->step_seconds + flow->builds_per_step * flow->build_seconds);
    const double settling = coupling::settling_time(scene, numbers), time = std::min(scene.run.until, settling);
    if (time > part_for_flow * budget * pace) {
      const bool carried = settling < scene.run.until;
      play.kind = carried ? Play::Kind::carried : Play::Kind::shortened;
      if (carried)
        play.scene = carried_from_the_start(play.scene, numbers.flow);
      else
        play.scene.run.until = std::max(0.5 * budget * pace, flow->step);
      if (!carried) play.scene.run.record_at.clear();
    }
  }
  if (!play.scene.numerics.splitting_step && only_sampled(scene) && !rdme::takes_turns(scene.numerics.sampler))
    play.scene.numerics.splitting_step = play.scene.run.until / finest;  // exact samplers go on where they stop
  return play;
}

Rehearsal rehearse(const scene::Scene& scene, const Maker& make, double budget) {
  Rehearsal result;
  const auto before = heap_bytes();
  const auto experiment = make(scene);
  const auto made = heap_bytes();
  result.experiment_bytes = made - before;
  const double begin = base::cpu_seconds();
  const auto stop = [&] {  // not before the pace can be seen, unless that takes too long
    const double elapsed = base::cpu_seconds() - begin;
    const bool seen = !result.prepared || result.realised.size() >= moments_to_see;
    return elapsed > (seen ? budget : patience * budget);
  };
  coupling::Progress progress{stop, {}};
  {
    const double start = base::cpu_seconds();
    progress.report = [&](double fraction) { result.prepared_fraction = fraction; };
    Recorder recorder(experiment->layout(), Recorder::Source::preparation);
    result.prepared = experiment->prepare(recorder, progress);
    result.prepare_seconds = base::cpu_seconds() - start;
  }
  result.shared_bytes = heap_bytes() - made;
  if (!result.prepared) return result;
  const auto prepared = heap_bytes();
  const double start = base::cpu_seconds();
  std::size_t peak = prepared;
  progress.report = [&](double fraction) {
    result.realised.push_back({fraction, base::cpu_seconds() - start});
    if (result.realised.size() < 4) peak = std::max(peak, heap_bytes());
  };
  Recorder recorder(experiment->layout(), Recorder::Source::realisation);
  coupling::Outcome outcome;
  result.finished = experiment->realise(0, recorder, progress, outcome);
  result.closing_seconds =
      base::cpu_seconds() - start - (result.realised.empty() ? 0.0 : result.realised.back().seconds);
  result.state_bytes = peak - prepared;
  progress.report = {};
  if (!result.finished && !rdme::takes_turns(scene.numerics.sampler)) {
    const double begin_to_foretell = base::cpu_seconds();
    result.activity = experiment->activity([&] { return base::cpu_seconds() - begin_to_foretell > budget; });
  }
  for (std::uint32_t k = 1; result.finished && !stop() && int(k) < std::min(experiment->scene().run.realisations, 20);
       ++k) {
    const double again = base::cpu_seconds();
    if (experiment->realise(k, recorder, progress, outcome)) result.others.push_back(base::cpu_seconds() - again);
  }
  return result;
}

}  // namespace shmoo::run
