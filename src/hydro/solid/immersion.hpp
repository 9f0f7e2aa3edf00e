#pragma once
// Elastic solids in a fluid: their particles are walls to it, with their own velocity and acceleration, and take the
// opposite of every force that they give it, so that momentum closes pair by pair. Solid and fluid exchange impulses at
// the ends of the fluid's step; in between the solid takes the steps that its waves need.
#include "hydro/solid/solids.hpp"
#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

template <int D>
class Immersion {
 public:
  using Vec = base::Vec<D>;

  Immersion(const scene::Scene& scene, const sph::Filling<D>& filling);

  const Solids<D>& solids() const { return solids_; }
  Solids<D>& solids() { return solids_; }
  bool empty() const { return solids_.empty(); }

  // The columns that solids bring, and what they show at the start. Throws base::InputError where the scene asks for
  // what they cannot do.
  void prepare(State<D>& state, const scene::Scene& scene);
  // Half of a step's impulse of the present tractions.
  void push(double dt) { solids_.push(dt); }
  // From time t on for dt; then shows the fluid where the solids are.
  void advance(State<D>& state, double t, double dt);
  // After particles were sorted anew.
  void locate(const State<D>& state);
  // The solids' accelerations now hold what the fluid gives them.
  void take_tractions(const State<D>& state);
  // What bouncing back changed of the fluid's velocities, solids lose. `before`: those of rows.near_wall().
  void recoil(const State<D>& state, const sph::AnyKernel<D>& kernel, const std::vector<Vec>& before);

  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const;

 private:
  void show(State<D>& state) const;

  Solids<D> solids_;
  std::vector<std::vector<std::uint32_t>> place_;  // of each body's particles in the store
  std::vector<std::vector<Vec>> acceleration_;     // [m/s^2] smoothed
};

extern template class Immersion<2>;
extern template class Immersion<3>;

}  // namespace shmoo::hydro
