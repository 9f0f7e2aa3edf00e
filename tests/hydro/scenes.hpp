#pragma once
// Scenes for the tests of the flow, built in memory.
#include <cmath>
#include <string>

#include "hydro/fluid.hpp"
#include "scene/scene.hpp"
#include "sph/fill.hpp"

namespace shmoo::hydro::testing {

// A box of water-like fluid of unit density at rest: [0, size] on every axis, periodic everywhere, no effect but
// viscosity, density diffusion and transport velocity.
inline scene::Scene box_scene(int dimension, double size, double spacing, double viscosity) {
  scene::Scene scene;
  scene.file = "test.toml";
  scene.dimension = dimension;
  for (int a = 0; a < dimension; ++a) {
    scene.domain.upper[a] = size;
    scene.domain.sides[a][0].type = scene.domain.sides[a][1].type = scene::SideType::periodic;
  }
  scene.domain.spacing = spacing;
  scene.domain.material = 0;
  scene.materials.push_back({"fluid", scene::MaterialType::fluid, 1.0, viscosity, 0.0, {}, {}});
  scene.effects.flow = true;
  scene.effects.bounce_back = false;
  return scene;
}

inline void add_walls(scene::Scene& scene, int axis) {
  scene.domain.sides[axis][0].type = scene.domain.sides[axis][1].type = scene::SideType::wall;
  scene.effects.bounce_back = true;
}

// Plane Taylor-Green vortices of unit speed in the unit square at Re = 100.
inline scene::Scene taylor_green_scene(int particles) {
  auto scene = box_scene(2, 1.0, 1.0 / particles, 0.01);
  scene.flow.initial_velocity = {{0.0, "-cos(2*_pi*x)*sin(2*_pi*y)"}, {0.0, "sin(2*_pi*x)*cos(2*_pi*y)"}};
  scene.flow.reference_speed = 1.0;
  return scene;
}

// Poiseuille flow between walls one apart: force 0.8, nu = 0.1, unit density (sph-bvf, section 4.1), u = 4 y (1 - y).
inline scene::Scene poiseuille_scene(int particles) {
  const double spacing = 1.0 / particles;
  auto scene = box_scene(2, 1.0, spacing, 0.1);
  scene.domain.upper[0] = 10 * spacing;
  add_walls(scene, 1);
  scene.flow.body_force = scene::Point{0.8, 0.0, 0.0};
  return scene;
}

// A square cavity of unit size under a lid of unit speed.
inline scene::Scene cavity_scene(int particles, double reynolds) {
  auto scene = box_scene(2, 1.0, 1.0 / particles, 1.0 / reynolds);
  add_walls(scene, 0);
  add_walls(scene, 1);
  scene.domain.sides[1][1].velocity = {1.0, 0.0, 0.0};
  return scene;
}

template <int D>
Fluid<D> make_fluid(const scene::Scene& scene, const base::RandomKey& key = {1, 0}) {
  return Fluid<D>(scene, sph::fill<D>(scene), key);
}

}  // namespace shmoo::hydro::testing
