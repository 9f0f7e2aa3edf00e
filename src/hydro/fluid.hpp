#pragma once
// A weakly compressible SDPD fluid in D dimensions with walls and elastic solids, and the effects that its scene calls
// for. Results are bit-identical for any number of threads.
#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "hydro/effects/list.hpp"
#include "hydro/open/open_sides.hpp"
#include "hydro/scales.hpp"
#include "hydro/solid/immersion.hpp"
#include "hydro/spacings/spacings.hpp"
#include "hydro/state.hpp"
#include "hydro/wall_guard.hpp"
#include "hydro/wall_load.hpp"
#include "hydro/walls.hpp"
#include "scene/scene.hpp"
#include "sph/fill.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

template <int D>
class Fluid {
 public:
  using Vec = base::Vec<D>;

  // `filling` as placed by sph::fill for this scene. The key addresses the random numbers of this realisation. Throws
  // base::InputError where the scene's flow cannot be computed.
  Fluid(const scene::Scene& scene, sph::Filling<D> filling, const base::RandomKey& key = {});
  // The same with other effects than the scene's.
  Fluid(const scene::Scene& scene, sph::Filling<D> filling, Effects<D> effects);

  // One time step of the derived length. Throws base::RunError where the flow has blown up.
  void step() { step(step_limit()); }
  void step(double dt);  // [s] the same with a length of one's own; stability is then the caller's concern
  // Steps of equal length, none longer than derived, until the time is exactly `until` [s].
  void advance(double until);

  double time() const { return time_; }  // [s]
  double dt() const { return dt_; }      // [s] derived: the smallest of limits()
  std::uint64_t steps() const { return steps_; }

  // Columns are ordered for locality: look up a particle by its id. For solids see State.
  const sph::Particles<D>& particles() const { return state_.particles; }
  sph::Particles<D>& particles() { return state_.particles; }  // to set a state; call restart() after a change
  const State<D>& state() const { return state_; }
  const base::Box<D>& box() const { return state_.box; }
  const Scales<D>& scales() const { return state_.scales; }
  const Solids<D>& solids() const { return solids_.solids(); }
  Solids<D>& solids() { return solids_.solids(); }
  // Takes positions, velocities and densities as they now are in the store as the state to go on from.
  void restart();

  // The relative loss of weight of every particle, by persistent id, from now on; see Buoyancy.
  void buoy(const std::vector<double>& lightness);

  // The true velocity [m/s]: of a fluid particle, or of the solid's surface.
  Vec velocity(std::size_t index) const;

  // Means over the time since the last begin_interval(), 0 for solids. Their columns exist from the first call on.
  void begin_interval();
  Vec mean_velocity(std::size_t index) const;  // [m/s] of the fluid
  Vec mean_shift(std::size_t index) const;     // [m/s] transport minus fluid velocity; 0 without transport velocity

  double kinetic_energy() const;     // [J]
  double max_speed() const;          // [m/s]
  double temperature() const;        // [J] m sum |v - mean|^2/(D (N - 1)); 0 for fewer than two particles
  double density_error() const;      // max |rho/rho0 - 1|
  double smallest_distance() const;  // of two fluid particles, in spacings; infinite for fewer than two
  Vec momentum() const;              // [kg m/s]
  WallLoad<D> wall_load(std::uint16_t material, const Vec& about) const;  // on a solid; layers beyond a side included

  // Where particles enter and leave, and where they are split and merged; null where they do not.
  const OpenSides<D>* open_sides() const { return open_ ? &*open_ : nullptr; }
  const Spacings<D>* spacings() const { return spacings_ ? &*spacings_ : nullptr; }
  // The places of particles in records; null where they are the ids, as none comes or goes.
  const Places* places() const { return places_ ? &*places_ : nullptr; }
  std::uint64_t bounces() const { return bounces_; }  // velocities thrown back at walls so far
  std::uint64_t draws() const { return draws_; }      // random numbers drawn so far, each pair's counted once
  // Where friction is implicit, else null.
  const ImplicitFriction<D>* implicit_friction() const {
    return effects_.implicit_friction ? &*effects_.implicit_friction : nullptr;
  }
  std::vector<std::string> effects() const { return effects_.names(); }
  const std::vector<StepLimit>& limits() const { return limits_; }
  const std::vector<Derived>& derived() const { return derived_; }

 private:
  struct Bare {};
  Fluid(const scene::Scene& scene, sph::Filling<D>&& filling, Bare);  // without effects
  void initialise(const scene::Scene& scene);
  void find_step();
  void rebuild();             // lets particles in and out, splits and merges them, and lists who is near whom
  double step_limit() const;  // [s] now
  void evaluate(double dt);
  void kick(double dt, double root);
  void rub(double dt);  // implicit friction in place of the second kick
  void drift(double dt);
  template <class Velocity>
  void fill_walls(Velocity&& velocity);  // the velocity [m/s] of walls, by particle
  void fill_slots();                     // for the first sweep
  void fill_stress();                    // and for the second
  void reflect();                        // what has passed a mirror
  void bounce();
  void check() const;

  Effects<D> effects_;
  std::vector<Derived> derived_;
  std::vector<StepLimit> limits_;
  Immersion<D> solids_;
  std::optional<OpenSides<D>> open_;
  std::optional<Spacings<D>> spacings_;
  std::optional<Places> places_;
  typename Blocks<D>::Mirrors mirrors_;
  bool any_mirror_ = false, enclosed_, covered_;
  State<D> state_;
  sph::AnyKernel<D> kernel_;
  Walls<D> walls_;
  WallGuard<D> guard_;
  double time_ = 0, dt_ = 0, last_dt_ = 0, interval_ = 0, fastest_ = 0;
  std::uint64_t steps_ = 0, evaluations_ = 0, bounces_ = 0, draws_ = 0;
};

extern template class Fluid<2>;
extern template class Fluid<3>;

}  // namespace shmoo::hydro
