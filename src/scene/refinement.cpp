#include "scene/refinement.hpp"

#include "scene/motion.hpp"

namespace shmoo::scene {

const char* misfit_of_refinements(const Scene& scene) {
  const auto& numerics = scene.numerics;
  if (scene.dimension != 2) return "two spacings are for scenes of two dimensions so far; remove it";
  if (!scene.effects.flow) return "only where the fluid moves may particles stand closer together; remove it";
  if (!scene.species.empty())
    return "species cannot live on particles of two spacings yet: those that pass from one to the other are split and "
           "merged, which molecules do not follow; remove it or the species";
  if (has_solids(scene)) return "elastic solids do not go together with two spacings yet; remove it";
  if (scene.effects.thermal_noise)
    return "thermal noise has no law for particles that are split and merged; remove it or switch "
           "effects.thermal_noise off";
  if (numerics.viscous_step == ViscousStep::implicit_step)
    return "the implicit viscous step does not know two spacings yet; remove it or numerics.viscous_step";
  if (numerics.density == DensityForm::summation)
    return "summed densities do not know two spacings yet; remove it or numerics.density";
  if (numerics.shepard_every > 0)
    return "the Shepard filter does not know two spacings yet; remove it or numerics.shepard_every";
  for (const auto& material : scene.materials)
    if (material.type == MaterialType::wall && material.motion)
      return "a wall whose particles move would leave its spacing; remove it or let the wall's surface slide";
  return nullptr;
}

}  // namespace shmoo::scene
