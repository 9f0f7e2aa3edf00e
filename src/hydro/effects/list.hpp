#pragma once
// The one list of all effects that a flow can have. To add one: its header above, its slot or entry below, its line in
// choose().
#include "hydro/effects/body.hpp"
#include "hydro/effects/bounce_back.hpp"
#include "hydro/effects/closed_room.hpp"
#include "hydro/effects/density_diffusion.hpp"
#include "hydro/effects/density_form.hpp"
#include "hydro/effects/density_tie.hpp"
#include "hydro/effects/pressure.hpp"
#include "hydro/effects/shepard_filter.hpp"
#include "hydro/effects/thermal_noise.hpp"
#include "hydro/effects/transport_velocity.hpp"
#include "hydro/effects/viscosity.hpp"
#include "hydro/implicit_friction.hpp"

namespace shmoo::hydro {

template <int D>
struct Effects {
  std::variant<SymmetricPressure, DifferencePressure, RiemannPressure> pressure;
  std::variant<DensityByContinuity, DensityBySummation> density;
  DiffusionSlot density_diffusion;
  std::optional<ShepardFilter<D>> shepard_filter;
  std::optional<ClosedRoom<D>> closed_room;
  std::optional<DensityTie<D>> density_tie;
  Slot<TransportVelocity<D>> transport_velocity;
  Slot<Viscosity<D>> viscosity;                          // explicit, or
  std::optional<ImplicitFriction<D>> implicit_friction;  // in its place
  Slot<ThermalNoise<D>> thermal_noise;
  std::optional<BounceBack<D>> bounce_back;
  BodyEffects<D> body;

  // What the scene calls for.
  static Effects choose(const scene::Scene& scene, const Scales<D>& scales, const base::RandomKey& key);

  std::vector<std::string> names() const;
  // Takes an effect out, as if the scene did not call for it; false where it is none that can be left out.
  bool remove(std::string_view name);
  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const;
  // Asks the store for the columns that these effects need.
  void require_columns(State<D>& state) const;
};

extern template struct Effects<2>;
extern template struct Effects<3>;

}  // namespace shmoo::hydro
