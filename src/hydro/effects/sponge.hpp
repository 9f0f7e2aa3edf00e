#pragma once
// Sponge inflow for the velocity, in rate form: dv/dt = -(v - v_target) phi(x)/tau (thesis Eq. 2.36; its Eq. 2.37
// relaxes per step instead of per time). Integrated exactly over a step, so that tau brings no step limit.
#include "hydro/effects/body.hpp"
#include "sph/sponge.hpp"

namespace shmoo::hydro {

template <int D>
class Sponge final : public BodyEffect<D> {
 public:
  // `inflow` must have a velocity and a box for its zone.
  Sponge(const scene::Inflow& inflow, double relaxation_time, double viscosity);
  Sponge(const Sponge&) = delete;  // zone_ refers to inflow_
  Sponge& operator=(const Sponge&) = delete;

  static void choose(const scene::Scene& scene, const Scales<D>& scales, BodyEffects<D>& list);

  const char* name() const override { return "sponge inflow"; }
  void describe(std::vector<Derived>& list) const override;
  void apply(const BodyView<D>& view, std::span<const std::uint32_t> particles) const override;

  double relaxation_time() const { return relaxation_time_; }  // [s]

 private:
  scene::Inflow inflow_;
  sph::Sponge zone_;
  base::Vec<D> target_;
  double relaxation_time_;
};

extern template class Sponge<2>;
extern template class Sponge<3>;

}  // namespace shmoo::hydro
