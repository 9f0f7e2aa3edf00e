#pragma once
// The particles of one elastic body, in an order of their own, and what a law of elasticity does to them. Volumes,
// masses and forces in the per-depth convention.
#include <cstdint>
#include <vector>

#include "base/box.hpp"
#include "hydro/solid/elastic_law.hpp"

namespace shmoo::hydro {

template <int D>
struct Body {
  using Vec = base::Vec<D>;

  std::string name;
  std::uint16_t material = 0;
  scene::ElasticLaw law = scene::ElasticLaw::neo_hookean;
  double density = 0;            // [kg/m^3] at rest
  double spacing = 0;            // [m] at the start
  double volume = 0;             // [m^D] of a particle at the start
  double shear = 0;              // [Pa] G0
  double bulk = 0;               // [Pa] K
  Vec body_force = Vec::Zero();  // [m/s^2]

  std::optional<scene::Softening> softening;

  std::vector<std::uint32_t> id;
  std::vector<Vec> start;         // [m]
  std::vector<Vec> displacement;  // [m]
  std::vector<Vec> velocity;      // [m/s]
  std::vector<Vec> force;         // [N/m^(3-D)] of elasticity
  std::vector<Vec> traction;      // [N/m^(3-D)] of the fluid
  std::vector<bool> held;         // follows the motion of its material
  std::vector<double> softness;   // [1] G/G0, where a species softens; empty: 1

  std::size_t size() const { return id.size(); }
  double mass() const { return density * volume; }
  // The speed of pressure waves [m/s] at rest, unsoftened.
  double wave_speed() const { return std::sqrt((bulk + 4.0 / 3.0 * shear) / density); }
  Moduli moduli(std::size_t i) const { return {softness.empty() ? shear : softness[i] * shear, bulk}; }
};

template <int D>
class Elasticity {
 public:
  virtual ~Elasticity() = default;
  // The forces where the particles are now, dt [s] after the last time, in which they had the body's velocities.
  // Throws base::RunError where the body cannot be what it has become.
  virtual void find_forces(Body<D>& body, double dt) = 0;
  virtual double step_limit(const Body<D>& body) const = 0;                       // [s] now
  virtual double energy(const Body<D>& body) const = 0;                           // [J/m^(3-D)]
  virtual Stress<D> stress(const Body<D>& body, std::size_t particle) const = 0;  // [Pa] Cauchy's
  virtual double density(const Body<D>& body, std::size_t particle) const = 0;    // [kg/m^3]
};

}  // namespace shmoo::hydro
