#include "coupling/flow_costs.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/clock.hpp"
#include "hydro/fluid.hpp"

namespace shmoo::coupling {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double shortest_block = 2e-3;  // [s] that is still timed well

// The scene's flow without one effect, and what a step of it took. Differences are taken between the least times.
template <int D>
struct Variant {
  std::string without;  // empty: nothing is left out
  std::unique_ptr<hydro::Fluid<D>> fluid;
  double least = infinite;  // [s]

  void run(int steps) {
    const double start = base::cpu_seconds();
    for (int k = 0; k < steps; ++k) fluid->step();
    least = std::min(least, (base::cpu_seconds() - start) / steps);
  }
};

template <int D>
Variant<D> make_variant(const scene::Scene& scene, const std::string& without) {
  auto filling = sph::fill<D>(scene);
  std::vector<hydro::Derived> ignored;
  const auto scales = hydro::derive_scales<D>(scene, filling, ignored);
  auto effects = hydro::Effects<D>::choose(scene, scales, {scene.run.seed, 0});
  if (!without.empty()) effects.remove(without);
  return {without, std::make_unique<hydro::Fluid<D>>(scene, std::move(filling), std::move(effects))};
}

// The scene's flow as it is comes first.
template <int D>
std::vector<Variant<D>> make_variants(const scene::Scene& scene) {
  std::vector<Variant<D>> variants;
  variants.push_back(make_variant<D>(scene, ""));
  auto names = variants.front().fluid->effects();
  names.erase(std::unique(names.begin(), names.end()), names.end());
  for (const auto& name : names) {
    auto variant = make_variant<D>(scene, name);
    if (variant.fluid->effects() != variants.front().fluid->effects()) variants.push_back(std::move(variant));
  }
  return variants;
}

// In turns, so that what else the machine does meets all alike.
template <int D>
void run_in_turns(std::vector<Variant<D>>& variants, double budget) {
  const double begin = base::cpu_seconds();
  for (auto& variant : variants) variant.run(1);
  const int steps = std::clamp(int(std::ceil(shortest_block / variants.front().least)), 1, 1000);
  do {
    for (auto& variant : variants) variant.run(steps);
  } while (base::cpu_seconds() - begin < budget);
}

template <int D>
EffectCost cost_of(const Variant<D>& whole, const Variant<D>& part) {
  EffectCost cost{.name = part.without, .step_limit = infinite, .step_without = part.fluid->dt()};
  cost.seconds = std::max(0.0, whole.least - part.least);
  cost.share = cost.seconds / whole.least;
  for (const auto& limit : whole.fluid->limits())
    if (limit.name == part.without) cost.step_limit = limit.value;
  const auto& kept = part.fluid->particles().columns();
  for (const auto& column : whole.fluid->particles().columns()) {
    const auto same = [&](const auto& other) { return other->name() == column->name(); };
    if (std::any_of(kept.begin(), kept.end(), same)) continue;
    cost.bytes += column->bytes();
    cost.columns.push_back(column->name());
  }
  return cost;
}

// What a step takes on the whole, while others use the machine as they do now. In turns the variants push each other
// out of the caches; a run has them to itself. Steps that list pairs anew are counted apart.
template <int D>
double time_of_step(Variant<D>& variant, double budget) {
  std::vector<double> times;
  const auto& rows = variant.fluid->state().rows;
  const double begin = base::cpu_seconds();
  for (double start = begin; start - begin < budget || times.empty();) {
    const auto builds = rows.builds();
    variant.fluid->step();
    const double end = base::cpu_seconds();
    if (rows.builds() == builds || end - begin > 2.0 * budget) times.push_back(end - start);
    start = end;
  }
  const auto middle = times.begin() + long(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

// restart() lists the pairs and evaluates once, which is about a step of `step` seconds, without implicit friction. What
// takes long is timed well by one.
template <int D>
double time_of_build(Variant<D>& variant, double step, double budget) {
  double least = infinite, start = base::cpu_seconds();
  const double begin = start;
  for (int k = 0; k < 3 && start - begin < budget; ++k) {
    variant.fluid->restart();
    const double end = base::cpu_seconds();
    least = std::min(least, end - start);
    start = end;
  }
  return std::max(0.0, least - step);
}

template <int D>
double measure_speedup(Variant<D>& variant, int threads) {
  if (threads == 1) return 1.0;
  const auto wall = [&](int with) {
    omp_set_num_threads(with);
    double least = infinite;
    for (int k = 0; k < 5; ++k) {
      const double start = base::wall_seconds();
      variant.fluid->step();
      least = std::min(least, base::wall_seconds() - start);
    }
    return least;
  };
  const double many = wall(threads), one = wall(1);
  return std::max(1.0, one / many);
}

template <int D>
bool settles(const scene::Scene& scene, const hydro::Fluid<D>& fluid) {
  return fluid.implicit_friction() && scene.flow.initial_velocity.empty() && !scene.effects.thermal_noise;
}

// Goes on for `budget` seconds, and takes the mean of what came in the later half of the time. `others` [s] is what a
// step takes without friction.
template <int D>
FrictionCourse course_of_friction(Variant<D>& variant, double others, double budget) {
  const auto& fluid = *variant.fluid;
  const auto& solver = *fluid.implicit_friction();
  const auto go = [&](double seconds) {
    const double begin = base::cpu_seconds();
    do variant.fluid->step();
    while (base::cpu_seconds() - begin < seconds);
  };
  go(0.5 * budget);
  const auto first = double(fluid.steps()), solutions = double(solver.solutions());
  const double decline = solver.decline(), begin = base::cpu_seconds();
  go(0.5 * budget);
  const auto last = double(fluid.steps());
  return {std::max(0.0, (base::cpu_seconds() - begin) / (last - first) - others), std::sqrt(first * last),
          (solver.decline() - decline) / (double(solver.solutions()) - solutions)};
}

template <int D>
double least_without(const std::vector<Variant<D>>& variants, const std::string& effect) {
  for (const auto& variant : variants)
    if (variant.without == effect) return variant.least;
  return 0.0;
}

template <int D>
FlowCosts measure(const scene::Scene& scene, int threads, double budget) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  auto variants = make_variants<D>(scene);
  run_in_turns(variants, 0.7 * budget);
  auto& whole = variants.front();
  const auto& fluid = *whole.fluid;
  FlowCosts costs{.particles = fluid.particles().size(), .step = fluid.dt()};
  costs.column_bytes = fluid.particles().bytes();
  costs.row_bytes = fluid.state().rows.bytes();
  for (std::size_t v = 1; v < variants.size(); ++v) costs.effects.push_back(cost_of(whole, variants[v]));
  const double half_skin = 0.5 * (fluid.state().rows.cutoff() - fluid.scales().reach);
  costs.builds_per_step = std::min(1.0, fluid.scales().speed * fluid.dt() / half_skin);
  const double others =
      fluid.implicit_friction() ? least_without(variants, hydro::ImplicitFriction<D>::name) : whole.least;
  if (settles(scene, fluid)) {
    costs.friction = course_of_friction(whole, others, 0.9 * budget);
    costs.step_seconds = others + costs.friction->seconds;
  } else {
    costs.step_seconds = time_of_step(whole, 0.3 * budget);
  }
  costs.build_seconds = time_of_build(whole, others, 0.1 * budget);
  costs.speedup = measure_speedup(whole, threads);
  omp_set_num_threads(before);
  return costs;
}

}  // namespace

FlowCosts measure_flow(const scene::Scene& scene, int threads, double budget) {
  return scene.dimension == 2 ? measure<2>(scene, threads, budget) : measure<3>(scene, threads, budget);
}

}  // namespace shmoo::coupling
