#pragma once
// What the user says of elastic solids. Computes nothing. SI units.
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "scene/quantity.hpp"

namespace shmoo::scene {

struct Shape;

enum class ElasticLaw {
  hooke_jaumann,           // updated Lagrangian, rate form with artificial stress
  saint_venant_kirchhoff,  // total Lagrangian, as the next
  neo_hookean
};

// The shear modulus falls with a species: G = G0 max(least, 1 - coefficient C).
struct Softening {
  int species = 0;
  double coefficient = 0;  // [m^3/molecule]
  double least = 0.01;     // of G0
};

// Wall growth by insertion in both directions of the wall at the rate gamma = coefficient C max(0, stress -
// yield_stress) [1/s], stress the mean tension in the wall.
struct Growth {
  int species = 0;
  double coefficient = 0;   // [m^3/(molecule Pa s)]
  double yield_stress = 0;  // [Pa]
};

struct Elastic {
  ElasticLaw law = ElasticLaw::neo_hookean;
  double shear_modulus = 0;  // [Pa] G0
  double poisson_ratio = 0;
  std::optional<Softening> softening;
  std::optional<Growth> growth;
  std::shared_ptr<const Shape> fixed;       // particles that start inside are held, or follow the material's motion
  std::vector<Quantity> initial_velocity;   // [m/s], one per axis; empty: at rest
  std::array<double, 3> body_force{};       // [m/s^2], acceleration
  double artificial_stress = 0.2;           // [1] of hooke_jaumann, against clumping in tension
  double artificial_viscosity = 1.0;        // [1] of hooke_jaumann, Monaghan's alpha
};

// A species enters the wall around its tip, its end on the axis that is farthest along x, through all its thickness:
// dC/dt = rate w(s) (concentration - C), w = exp(-(s/width)^2) with s the arc length from the tip on the outer surface.
struct TipSource {
  int species = 0;
  double rate = 0;           // [1/s]
  double concentration = 0;  // [molecules/m^3]
  double width = 0;          // [m]
};

enum class Motion {
  dynamic,       // every wave is resolved in time
  quasi_static,  // a sequence of equilibria
};

struct Mechanics {
  Motion motion = Motion::dynamic;
  double turgor = 0;           // [Pa] pressure inside a closed solid
  std::optional<double> step;  // [s] of quasi-static motion; derived where absent
  double tolerance = 1e-3;     // relative error of lengths that a derived step may cost
  int columns = 0;             // of particles along half of the wall's outline; 0: derived
  std::vector<TipSource> sources;
};

}  // namespace shmoo::scene
