#include "coupling/quasi_static/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::coupling {
namespace {

constexpr double first_part = 1e-4;    // of run.until
constexpr double longest_part = 0.01;  // of run.until
constexpr double share = 0.01;         // of the tolerance that any step may take, as where a wall suddenly softens
constexpr double safety = 0.9, least_factor = 0.25, most_factor = 1.5;

// Steps of first order shift what happens by half a step, so that a length that grows steadily is off by half a step's
// part of the time.
double first_step(const scene::Scene& scene, bool controlled) {
  if (controlled) return first_part * scene.run.until;
  return scene.mechanics.step.value_or(2.0 * scene.mechanics.tolerance * scene.run.until);
}

}  // namespace

StepControl::StepControl(const scene::Scene& scene, bool random)
    : tolerance_(scene.mechanics.tolerance),
      until_(scene.run.until),
      controlled_(!scene.mechanics.step && !random),
      step_(first_step(scene, controlled_)),
      shortest_(until_) {}

void StepControl::learn(double dt, double change, double length) {
  const double error = 0.5 * std::abs(change - rate_ * dt);
  rate_ = change / dt;
  error_ += error;
  shortest_ = std::min(shortest_, dt);
  longest_ = std::max(longest_, dt);
  ++steps_;
  if (!controlled_) return;
  const double allowed = tolerance_ * length * std::max(dt / until_, share);
  const double factor = error > 0.0 ? std::clamp(safety * allowed / error, least_factor, most_factor) : most_factor;
  step_ = std::min(dt * factor, longest_part * until_);
}

}  // namespace shmoo::coupling
