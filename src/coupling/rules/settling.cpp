#include "coupling/rules/settling.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "coupling/live_flow.hpp"

namespace shmoo::coupling {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double peak_of_channel = 1.5;  // largest over mean speed of plane Poiseuille flow

// [s] between two looks at whether the flow is steady
double window(const FlowNumbers& flow) {
  return part_of_time_scale * std::min(flow.length / flow.speed, flow.length * flow.length / flow.kinematic_viscosity);
}

}  // namespace

double flow_interval(const scene::Scene& scene, const Numbers& numbers) {
  const bool fed =
      std::any_of(scene.inflows.begin(), scene.inflows.end(), [](const auto& in) { return in.velocity.has_value(); });
  const double fastest = numbers.flow.speed * (fed && numbers.walls ? peak_of_channel : 1.0);
  const double by_motion = most_movement * numbers.spacing / fastest;
  return scene.numerics.steady_tolerance ? std::min(by_motion, window(numbers.flow)) : by_motion;
}

// The slowest mode between plates w apart decays as exp(-t/tau), tau = w^2/(pi^2 nu): a look at time t sees the
// relative change exp(-(t - d)/tau) (1 - exp(-d/tau)) over the d since the last look.
double settling_time(const scene::Scene& scene, const Numbers& numbers) {
  const auto& flow = numbers.flow;
  if (!scene.numerics.steady_tolerance || !numbers.walls || !scene.flow.initial_velocity.empty()) return infinite;
  if (!(flow.speed > 0.0) || scene.effects.thermal_noise) return infinite;
  const double tau = flow.length * flow.length / (std::numbers::pi * std::numbers::pi * flow.kinematic_viscosity);
  const double interval = flow_interval(scene, numbers);
  const double look = std::ceil(window(flow) / interval * (1.0 - 1e-9)) * interval;
  const double first = -std::expm1(-look / tau);
  const double looks = 1.0 + std::ceil(std::max(0.0, tau / look * std::log(first / *scene.numerics.steady_tolerance)));
  return looks * look;
}

}  // namespace shmoo::coupling
