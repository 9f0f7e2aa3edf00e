#include "run/explain/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/rules/settling.hpp"
#include "run/ensemble.hpp"
#include "run/explain/coarse_wall.hpp"
#include "run/explain/memory.hpp"
#include "run/recorder.hpp"
#include "scene/motion.hpp"

namespace shmoo::run {
namespace {

using Kind = Play::Kind;

constexpr double carried_intervals = 3;  // at the start, moving, and standing

bool anything_random(const scene::Scene& scene) {
  const auto sampled = [](const auto& species) { return species.method != scene::SpeciesMethod::deterministic; };
  return (scene.effects.flow && scene.effects.thermal_noise) ||
         std::any_of(scene.species.begin(), scene.species.end(), sampled);
}

// The part of the run after which no more molecules come to be than there are: the fluid has crossed the domain.
double until_even(const scene::Scene& scene, const coupling::Numbers& numbers) {
  if (!scene.effects.flow || !(numbers.flow.speed > 0.0)) return 1.0;
  double longest = 0.0;
  for (std::size_t a = 0; a < std::size_t(scene.dimension); ++a)
    longest = std::max(longest, scene.domain.upper[a] - scene.domain.lower[a]);
  return longest / numbers.flow.speed / scene.run.until;
}

// A flow that nothing drives slows down as exp(-nu k^2 t), k = 2 pi/L on every axis; pairs are listed the less often.
double mean_pace(const scene::Scene& scene, const coupling::Numbers& numbers, double time) {
  const bool driven = scene.flow.body_force || scene::has_open_sides(scene) || !scene.inflows.empty() ||
                      scene.flow.initial_velocity.empty();
  if (driven || numbers.walls) return 1.0;
  const double k2 = scene.dimension * std::pow(2.0 * M_PI / numbers.flow.length, 2);
  const double decay = numbers.flow.kinematic_viscosity * k2 * time;
  return decay > 0.0 ? -std::expm1(-decay) / decay : 1.0;
}

double flow_seconds(const scene::Scene& scene, const coupling::Numbers& numbers, const coupling::FlowCosts& flow,
                    const Forecast& forecast) {
  const double builds = flow.builds_per_step * mean_pace(scene, numbers, forecast.flow_time);
  const double step = flow.friction
                          ? flow.step_seconds - flow.friction->seconds + flow.friction->mean(forecast.flow_steps)
                          : flow.step_seconds;
  return forecast.flow_steps * (step + builds * flow.build_seconds);
}

void plan_flow(const scene::Scene& scene, const coupling::Numbers& numbers, Forecast& forecast) {
  if (!scene.effects.flow) return;
  const double settling = coupling::settling_time(scene, numbers);
  forecast.steady = settling < scene.run.until;
  forecast.flow_time = std::min(settling, scene.run.until);
  // Steps of equal length fill an interval.
  const double interval = std::min(coupling::flow_interval(scene, numbers), forecast.flow_time);
  forecast.flow_steps = forecast.flow_time / interval * std::ceil(interval / numbers.flow.step);
}

// Every realisation computes its own flow, and keeps nothing of it for others.
bool own_flow(const scene::Scene& scene) { return scene.effects.thermal_noise || scene::acts_back(scene); }

// Intervals whose voxels are kept for all realisations.
double kept_intervals(const scene::Scene& scene, const coupling::Numbers& numbers, const Forecast& forecast) {
  if (scene.species.empty() || own_flow(scene)) return 0.0;
  const double moving = forecast.flow_time > 0.0 ? forecast.flow_time / coupling::flow_interval(scene, numbers) : 0.0;
  return std::ceil(moving * (1.0 - 1e-9)) + (forecast.steady ? 2.0 : 1.0);
}

// Seconds of a run that is `whole` times as long as what was played, from its beginning. The first interval may take
// longer than others and comes once.
double at_that_pace(const std::vector<Moment>& moments, double told, double whole) {
  if (moments.empty()) return told * whole;
  const auto &first = moments.front(), &last = moments.back();
  if (!(last.fraction > first.fraction)) return last.fraction > 0.0 ? whole * last.seconds / last.fraction : told;
  const double pace = (last.seconds - first.seconds) / (last.fraction - first.fraction);
  return first.seconds + pace * (whole - first.fraction);
}

void add_times(const scene::Scene& scene, const coupling::Numbers& numbers, const coupling::FlowCosts* flow,
               const Play& play, const Rehearsal& rehearsal, Forecast& forecast) {
  const double played = play.scene.run.until / scene.run.until;
  const auto course = rehearsal.prepared ? extrapolate(rehearsal, until_even(scene, numbers) / played) : Course{};
  if (anything_random(scene)) forecast.realisation_seconds = course.each / played;
  forecast.shared_seconds = rehearsal.prepare_seconds;
  if (!rehearsal.prepared || play.kind == Kind::shortened)
    forecast.shared_seconds = at_that_pace(rehearsal.preparing, rehearsal.prepare_seconds, 1.0 / played);
  if (!rehearsal.coarse.empty()) forecast.shared_seconds = by_coarse(rehearsal.preparing, rehearsal.coarse);
  const bool chemistry_too = play.kind == Kind::shortened && !scene.species.empty() && !anything_random(scene);
  if (play.kind != Kind::whole && !chemistry_too)
    forecast.shared_seconds = flow_seconds(scene, numbers, *flow, forecast);
  const double moving = play.kind == Kind::carried ? kept_intervals(scene, numbers, forecast) - 1.0 : 1.0;
  forecast.once_seconds = moving * course.moving_once + course.standing_once;
  forecast.cpu_seconds = forecast.start_seconds + forecast.shared_seconds + forecast.once_seconds +
                         scene.run.realisations * forecast.realisation_seconds;
  const double workers = std::min(forecast.threads, scene.run.realisations);
  const double speedup = flow ? flow->speedup : 1.0;
  forecast.wall_seconds = forecast.start_seconds + forecast.shared_seconds / speedup + forecast.once_seconds +
                          forecast.realisation_seconds * std::ceil(scene.run.realisations / workers);
}

using Parts = std::vector<std::pair<std::string, double>>;  // [bytes]

double sum(const Parts& parts) {
  double bytes = 0;
  for (const auto& part : parts) bytes += part.second;
  return bytes;
}

// What the run holds all the time, and the largest of what it holds while it prepares, realises and writes.
void add_memory(const scene::Scene& scene, const coupling::Numbers& numbers, const Play& play,
                const Rehearsal& rehearsal, const coupling::RecordLayout& layout, std::size_t idle_bytes,
                Forecast& forecast) {
  const double workers = anything_random(scene) ? std::min(forecast.threads, scene.run.realisations) : 1;
  const auto filled = [&](const coupling::FieldInfo& info) {
    for (const auto& one : numbers.species)
      if (one.name == info.name) return double(one.home) / double(numbers.voxels);
    return 1.0;
  };
  double more = 1.0;  // intervals kept over intervals rehearsed
  if (play.kind == Kind::carried) more = kept_intervals(scene, numbers, forecast) / carried_intervals;
  if (play.kind == Kind::shortened && kept_intervals(scene, numbers, forecast) > 0.0)
    more = scene.run.until / play.scene.run.until;
  const double recorded = recorder_bytes(layout, false);
  Parts parts{{"program and libraries", double(rehearsal.program_bytes + idle_bytes)},
              {"particles, network, records of their places", double(rehearsal.experiment_bytes)},
              {"statistics of all realisations", results_bytes(layout, scene.run.realisations, filled)},
              {"voxels and jump tables of the intervals", more * rehearsal.kept_bytes},
              {"gaps between them", rehearsal.gap_bytes}};
  const Parts preparing{{"what is shared, under way", rehearsal.preparing_bytes}};
  Parts realising{{"realisations under way", workers * rehearsal.realising_bytes},
                  {"what they record", workers * recorded}};
  const std::pair<std::string, double> library{"the library that writes the result", library_bytes};
  if (scene.run.realisations > workers && forecast.wall_seconds > EnsembleOptions{}.write_interval)
    realising.push_back(library);  // it has written before
  const Parts writing{{"what realisations under way record", (workers - 1.0) * recorded},
                      {"writing the result", writing_bytes(layout)},
                      library};
  const double lasting = sum(parts) - parts.front().second;  // is not all there when the experiment is made
  const Parts making{{"setting up the scene", std::max(0.0, rehearsal.making_bytes - lasting)}};
  const auto& largest =
      std::max({making, preparing, realising, writing}, [](const auto& a, const auto& b) { return sum(a) < sum(b); });
  parts.insert(parts.end(), largest.begin(), largest.end());
  for (const auto& [name, bytes] : parts)
    if (bytes >= 1.0) forecast.memory.emplace_back(name, std::size_t(bytes));
  forecast.bytes = std::size_t(sum(parts));
}

const char* told(Kind kind) {
  switch (kind) {
    case Kind::carried:
      return "the flow for some steps, and the chemistry on a uniform steady flow in its place";
    case Kind::shortened:
      return "the flow for some steps, and the run with an earlier end";
    default:
      return "the run itself, from its beginning";
  }
}

}  // namespace

Forecast make_forecast(const scene::Scene& scene, const coupling::Numbers& numbers,
                       const std::optional<coupling::FlowCosts>& flow, const Maker& make,
                       const coupling::RecordLayout& layout, int threads, const Idle& idle, double budget) {
  Forecast forecast{.start_seconds = idle.seconds, .threads = threads};
  const auto* costs = flow ? &*flow : nullptr;
  plan_flow(scene, numbers, forecast);
  auto play = choose_play(scene, numbers, costs, budget);
  auto rehearsal = rehearse(play.scene, make, budget);
  if (!rehearsal.prepared && costs && anything_random(scene)) {  // slower than it seemed, and the best is to come
    play = choose_play(scene, numbers, costs, 0.0);
    rehearsal = rehearse(play.scene, make, budget);
  }
  forecast.how = told(play.kind);
  add_times(scene, numbers, costs, play, rehearsal, forecast);
  add_memory(scene, numbers, play, rehearsal, layout, idle.heap_bytes, forecast);
  return forecast;
}

}  // namespace shmoo::run
