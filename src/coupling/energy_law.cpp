#include "coupling/energy_law.hpp"

namespace shmoo::coupling {
namespace {

constexpr double tolerated = 0.01;  // sound in the fluid hides about a hundredth from its kinetic energy

bool any(const scene::Point& point) {
  return std::any_of(point.begin(), point.end(), [](double one) { return one != 0.0; });
}

bool moves(const scene::Material& material) {
  return material.motion || material.surface_motion || (material.elastic && any(material.elastic->body_force));
}

}  // namespace

bool undriven(const scene::Scene& scene) {
  const auto& all = scene.materials;
  const bool solid = std::any_of(all.begin(), all.end(), [](const auto& one) { return one.elastic.has_value(); });
  if (!solid || !scene.effects.flow || scene.effects.thermal_noise) return false;
  if (!scene.flow.buoyancy.empty() || !scene.inflows.empty()) return false;
  if (scene.flow.body_force && any(*scene.flow.body_force)) return false;
  for (const auto& sides : scene.domain.sides)
    for (const auto& side : sides)
      if (scene::is_open(side.type) || any(side.velocity)) return false;
  return std::none_of(all.begin(), all.end(), moves);
}

Experiment::Derived EnergyLaw::told() const {
  return {"largest rise of energy", rise(), "1",
          rise() > tolerated ? "WARNING: nothing drives fluid and solids, and still their energy rose: do not trust "
                               "this run; a solid is too soft for the fluid's pressures (see shmoo explain), or the "
                               "spacing too large"
                             : "of fluid and solids, which nothing drives; below 0.01 is sound"};
}

}  // namespace shmoo::coupling
