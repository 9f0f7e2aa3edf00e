#include "hydro/effects/density_diffusion.hpp"

#include "hydro/bare_fluid.hpp"
#include "hydro/lattice_moments.hpp"

namespace shmoo::hydro {

template <int D>
DensityDiffusion DensityDiffusion::derive(const scene::Scene& scene, const Scales<D>& scales) {
  const double sound = scales.sound_speed * scales.smoothing, nu = scales.kinematic_viscosity();  // [m^2/s]
  const double coefficient = 2.0 * delta * sound * (sound < 4.0 * nu ? sound / (4.0 * nu) : 1.0);
  if (!is_bare(scene)) return {coefficient};
  return {coefficient, lattice_moment(scene, scales, 2) / lattice_moment(scene, scales, 4)};
}

template DensityDiffusion DensityDiffusion::derive(const scene::Scene&, const Scales<2>&);
template DensityDiffusion DensityDiffusion::derive(const scene::Scene&, const Scales<3>&);

}  // namespace shmoo::hydro
