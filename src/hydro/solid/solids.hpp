#pragma once
// The elastic bodies of a scene in motion: leapfrog steps between the impulses that a fluid, where there is one, gives
// them. Results are bit-identical for any number of threads.
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "hydro/scales.hpp"
#include "hydro/solid/body.hpp"
#include "hydro/wall_motion.hpp"
#include "sph/fill.hpp"

namespace shmoo::hydro {

template <int D>
class Solids {
 public:
  using Vec = base::Vec<D>;

  // Takes the particles of role solid, as they stand at the start. Throws base::InputError where one cannot be a body.
  Solids(const scene::Scene& scene, const sph::Filling<D>& filling);

  bool empty() const { return bodies_.empty(); }
  std::span<const Body<D>> bodies() const { return bodies_; }
  std::span<Body<D>> bodies() { return bodies_; }

  // The longest step [s] that is stable now.
  double step_limit() const;
  // In as few steps of equal length as are stable. Throws base::RunError where a body cannot bear its load.
  void advance(double t, double dt);
  // The traction acts for this long [s] at once.
  void push(double dt);

  // Whether a species softens any body; and its modulus where that species has concentration(species, id) [1/m^3] at
  // the particle with this id.
  bool soften() const;
  void soften(const std::function<double(int, std::uint32_t)>& concentration);

  Vec position(const Body<D>& body, std::size_t particle) const;  // [m], inside the box along periodic axes
  double density(const Body<D>& body, std::size_t particle) const;
  double pressure(const Body<D>& body, std::size_t particle) const;  // [Pa] minus a third of the stress's trace

  double max_speed() const;       // [m/s]
  double volume() const;          // [m^D] now
  double kinetic_energy() const;  // [J]
  double elastic_energy() const;  // [J]
  Vec momentum() const;           // [kg m/s] of what is not held
  void describe(std::vector<Derived>& list) const;

 private:
  void add_body(const scene::Scene& scene, std::size_t material, const sph::Filling<D>& filling);
  void kick(Body<D>& body, double dt);
  void drift(Body<D>& body, double t, double dt);
  const Elasticity<D>& law(const Body<D>& body) const { return *laws_[std::size_t(&body - bodies_.data())]; }

  base::Box<D> box_;
  WallMotion<D> motion_;  // of what is held
  double depth_;          // [m^(3-D)]
  std::vector<Body<D>> bodies_;
  std::vector<std::unique_ptr<Elasticity<D>>> laws_;  // of each body
};

extern template class Solids<2>;
extern template class Solids<3>;

}  // namespace shmoo::hydro
