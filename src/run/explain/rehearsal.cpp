#include "run/explain/rehearsal.hpp"

#include <algorithm>
#include <cmath>

#include "base/clock.hpp"
#include "coupling/rules/settling.hpp"
#include "rdme/sampler.hpp"
#include "run/explain/coarse_wall.hpp"
#include "run/explain/memory.hpp"
#include "run/recorder.hpp"

namespace shmoo::run {
namespace {

constexpr std::size_t moments_to_see = 8;
constexpr double part_for_flow = 0.4;  // of the budget; a longer flow is left out
constexpr double patience = 2;         // budgets
constexpr double finest = 256;         // parts into which a play is cut to see its course
constexpr int most_realisations = 20;

// The velocity that drives the fluid, wherever it is driven.
scene::Point plug_velocity(const scene::Scene& scene, double speed) {
  for (const auto& inflow : scene.inflows)
    if (inflow.velocity) return *inflow.velocity;
  scene::Point velocity{};
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t side = 0; side < 2; ++side)
      if (!scene.domain.sides[a][side].inflow.empty()) velocity[a] = side == 0 ? speed : -speed;
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

// Plays what realisations share, and one of them, and looks how much memory either takes.
class Player {
 public:
  Player(const scene::Scene& scene, const Maker& make, double budget)
      : scene_(scene), budget_(budget), before_(heap_bytes()) {
    const Peak peak;
    experiment_ = make(scene);
    result_.making_bytes = double(peak.bytes());
    made_ = heap_bytes();
    result_.experiment_bytes = made_ - before_;
  }

  Rehearsal play() {
    begin_ = base::cpu_seconds();
    prepare();
    if (result_.prepared) {
      realise();
      if (!result_.finished && !rdme::takes_turns(scene_.numerics.sampler)) foretell();
      realise_others();
    }
    result_.program_bytes = program_bytes();
    return result_;
  }

 private:
  // Not before the pace can be seen, unless that takes too long.
  bool enough() const {
    const double elapsed = base::cpu_seconds() - begin_;
    const bool seen = !result_.prepared || result_.realised.size() >= moments_to_see;
    return elapsed > (seen ? budget_ : patience * budget_);
  }

  // What a part of the play took in memory at most, less what it has left behind and what it recorded. Between what it
  // has left behind lie gaps of what it freed, at most as large: `held` is all that was in memory at its end.
  double passing(const Peak& peak, double held, bool shared) {
    const double recorded = recorder_bytes(experiment_->layout(), shared), heap = double(heap_bytes() - made_);
    const double grown = std::max(0.0, heap - result_.kept_bytes);
    const double gaps = std::clamp(held - recorded - grown, 0.0, grown);
    result_.kept_bytes += grown;
    result_.gap_bytes += gaps;
    return std::max(0.0, double(peak.bytes()) - grown - gaps - recorded);
  }

  void prepare() {
    const Peak peak;
    double held = 0.0;
    const double start = base::cpu_seconds();
    {
      coupling::Progress progress{[&] { return enough(); },
                                  [&](double f) {
                                    result_.preparing.push_back({f, base::cpu_seconds() - start});
                                  }};
      Recorder recorder(experiment_->layout(), Recorder::Source::preparation);
      result_.prepared = experiment_->prepare(recorder, progress);
      held = peak.held();
    }
    result_.prepare_seconds = base::cpu_seconds() - start;
    result_.preparing_bytes = passing(peak, held, true);
  }

  void realise() {
    const Peak peak;
    double held = 0.0;
    const double start = base::cpu_seconds();
    {
      coupling::Progress progress{[&] { return enough(); },
                                  [&](double f) {
                                    result_.realised.push_back({f, base::cpu_seconds() - start});
                                  }};
      Recorder recorder(experiment_->layout(), Recorder::Source::realisation);
      coupling::Outcome outcome;
      result_.finished = experiment_->realise(0, recorder, progress, outcome);
      held = peak.held();
    }
    result_.closing_seconds =
        base::cpu_seconds() - start - (result_.realised.empty() ? 0.0 : result_.realised.back().seconds);
    result_.realising_bytes = passing(peak, held, false);
  }

  void foretell() {
    const double start = base::cpu_seconds();
    result_.activity = experiment_->activity([&] { return base::cpu_seconds() - start > budget_; });
  }

  void realise_others() {
    const int last = std::min(experiment_->scene().run.realisations, most_realisations);
    const coupling::Progress progress{[&] { return enough(); }, {}};
    for (int k = 1; result_.finished && !enough() && k < last; ++k) {
      const double start = base::cpu_seconds();
      Recorder recorder(experiment_->layout(), Recorder::Source::realisation);
      coupling::Outcome outcome;
      if (experiment_->realise(std::uint32_t(k), recorder, progress, outcome))
        result_.others.push_back(base::cpu_seconds() - start);
    }
  }

  const scene::Scene& scene_;
  double budget_, begin_ = 0;
  std::size_t before_;
  std::unique_ptr<coupling::Experiment> experiment_;
  std::size_t made_ = 0;
  Rehearsal result_;
};

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
  auto result = Player(scene, make, budget).play();
  if (!result.prepared && !result.preparing.empty()) result.coarse = coarse_course(scene, make, patience * budget);
  return result;
}

}  // namespace shmoo::run
