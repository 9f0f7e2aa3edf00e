#include "hydro/effects/viscosity.hpp"

#include "hydro/bare_fluid.hpp"

namespace shmoo::hydro {

// Where it shortens no step.
template <int D>
bool is_fourth_order(const scene::Scene& scene, const Scales<D>& scales) {
  const bool along = friction_beta<D>(scales.viscosity, scales.bulk_viscosity) != 0.0;
  if (along || !(scales.viscosity > 0.0) || scene.effects.thermal_noise || scales.shocks) return false;
  if (scene.numerics.density == scene::DensityForm::summation) return false;
  if (scene.numerics.viscous_step == scene::ViscousStep::implicit_step) return false;
  if (scene.numerics.reach < least_fourth_reach || !is_bare(scene)) return false;
  std::vector<StepLimit> acoustic, viscous;
  list_base_limits(scales, acoustic);
  Viscosity<D>{.fourth_order = true}.limits(scales, viscous);
  return viscous.front().value >= acoustic.front().value;
}

template bool is_fourth_order(const scene::Scene&, const Scales<2>&);
template bool is_fourth_order(const scene::Scene&, const Scales<3>&);

}  // namespace shmoo::hydro
