#pragma once
// What a quasi-static scene says of its wall, and the wall under turgor before anything grows, which all realisations
// start from.
#include "hydro/shell/equilibrium.hpp"
#include "hydro/shell/outline.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

struct WallPlan {
  // Throws base::InputError where the scene has no wall that can be computed so, or its turgor is at or beyond the
  // limit load.
  explicit WallPlan(const scene::Scene& scene);

  const scene::Elastic& elastic() const { return *scene.materials[std::size_t(material)].elastic; }
  // [m^3] of a particle: that of its mirror image, too, where the wall is no body of revolution.
  double real_volume(double shell_volume) const {
    return scene.axisymmetric ? shell_volume : 2.0 * scene.depth * shell_volume;
  }

  const scene::Scene& scene;
  int material = -1, filling_material = -1;  // of the wall; of what its cavity is filled with, or -1
  double centre = 0;                         // [m] x of the ring's centre
  hydro::Ring ring;
  hydro::Shell start;      // under turgor
  hydro::Points filling;   // [m] particles in the cavity, relaxed
  double tolerance = 0;    // [N], plane: [N/m]: largest force that an equilibrium may leave on a particle
  double force_scale = 0;  // the same unit: p R^2, plane: p R
  double length = 0;       // [m] from tip to back under turgor
};

}  // namespace shmoo::coupling
