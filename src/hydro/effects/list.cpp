#include "hydro/effects/list.hpp"

#include "base/error.hpp"
#include "hydro/effects/body_force.hpp"
#include "hydro/effects/buoyancy.hpp"
#include "hydro/effects/sponge.hpp"

namespace shmoo::hydro {

namespace {

bool sums_density(const scene::Scene& scene, bool shocks) {
  const auto form = scene.numerics.density;
  if (form == scene::DensityForm::automatic) return scene.effects.thermal_noise || shocks;
  return form == scene::DensityForm::summation;
}

void refuse_forms(const scene::Scene& scene, scene::PressureForm pressure, bool sums) {
  if (scene.effects.thermal_noise && !sums) {
    throw base::InputError(
        "numerics.density = \"continuity\" lets thermal noise make density wander off; remove it or turn "
        "effects.thermal_noise off");
  }
  if (scene.effects.thermal_noise && pressure == scene::PressureForm::riemann) {
    throw base::InputError(
        "numerics.pressure = \"riemann\" dissipates what thermal noise does not give back; remove it or turn "
        "effects.thermal_noise off");
  }
  if (scene.numerics.shepard_every > 0 && sums) {
    throw base::InputError(
        "numerics.shepard_every renormalises densities by continuity, and here they are summed over particles; remove "
        "it");
  }
}

// Sums over kernels cannot diffuse.
template <int D>
DiffusionSlot choose_diffusion(const scene::Scene& scene, const Scales<D>& scales, scene::PressureForm pressure) {
  if (!scene.effects.density_diffusion) return Absent{};
  if (pressure == scene::PressureForm::riemann) return RiemannDiffusion{scales.sound_speed};
  return DensityDiffusion::derive(scene, scales);
}

}  // namespace

template <int D>
Effects<D> Effects<D>::choose(const scene::Scene& scene, const Scales<D>& scales, const base::RandomKey& key) {
  Effects effects;
  const auto pressure = pressure_form(scene, scales);
  const bool sums = sums_density(scene, scales.shocks);
  refuse_forms(scene, pressure, sums);
  if (pressure == scene::PressureForm::difference) effects.pressure = DifferencePressure{};
  if (pressure == scene::PressureForm::riemann)
    effects.pressure = RiemannPressure{scales.sound_speed, scales.density * scales.sound_speed};
  if (sums) effects.density = DensityBySummation{scales.density / scales.lattice_sum};
  if (!sums) effects.density_diffusion = choose_diffusion(scene, scales, pressure);
  if (scene.numerics.shepard_every > 0)
    effects.shepard_filter = ShepardFilter<D>{std::uint64_t(scene.numerics.shepard_every)};
  if (!sums) effects.closed_room = ClosedRoom<D>::choose(scene);
  if (!sums) effects.density_tie = DensityTie<D>::choose(scene, scales);
  effects.transport_velocity = TransportVelocity<D>::choose(scene, scales);
  effects.viscosity = Viscosity<D>::choose(scene, scales);
  if (ImplicitFriction<D>::chosen(scene, scales)) {
    effects.implicit_friction.emplace(std::get<Viscosity<D>>(effects.viscosity));
    effects.viscosity = Absent{};
  }
  effects.thermal_noise = ThermalNoise<D>::choose(scene, scales, key);
  effects.bounce_back = BounceBack<D>::choose(scene);
  BodyForce<D>::choose(scene, scales, effects.body);
  Buoyancy<D>::choose(scene, scales, effects.body);
  Sponge<D>::choose(scene, scales, effects.body);
  return effects;
}

template <int D>
std::vector<std::string> Effects<D>::names() const {
  std::vector<std::string> names;
  const auto add = [&](const auto& slot) {
    std::visit(
        [&](const auto& effect) {
          if constexpr (present<std::decay_t<decltype(effect)>>) names.emplace_back(effect.name);
        },
        slot);
  };
  add(pressure);
  add(density);
  add(density_diffusion);
  if (shepard_filter) names.emplace_back(ShepardFilter<D>::name);
  if (closed_room) names.emplace_back(ClosedRoom<D>::name);
  if (density_tie) names.emplace_back(DensityTie<D>::name);
  add(transport_velocity);
  add(viscosity);
  if (implicit_friction) names.emplace_back(ImplicitFriction<D>::name);
  add(thermal_noise);
  if (bounce_back) names.emplace_back(BounceBack<D>::name);
  for (const auto& effect : body) names.emplace_back(effect->name());
  return names;
}

template <int D>
bool Effects<D>::remove(std::string_view name) {
  bool removed = false;
  const auto take = [&](auto& slot) {
    const auto named = [&](const auto& effect) {
      if constexpr (present<std::decay_t<decltype(effect)>>) return name == effect.name;
      return false;
    };
    if (!std::visit(named, slot)) return;
    slot = Absent{};
    removed = true;
  };
  take(density_diffusion);
  take(transport_velocity);
  take(viscosity);
  take(thermal_noise);
  if (removed && name == ThermalNoise<D>::name) density = DensityByContinuity{};  // as without noise
  if (shepard_filter && name == ShepardFilter<D>::name) {
    shepard_filter.reset();
    removed = true;
  }
  if (closed_room && name == ClosedRoom<D>::name) {
    closed_room.reset();
    removed = true;
  }
  if (density_tie && name == DensityTie<D>::name) {
    density_tie.reset();
    removed = true;
  }
  if (implicit_friction && name == ImplicitFriction<D>::name) {
    implicit_friction.reset();
    removed = true;
  }
  if (bounce_back && name == BounceBack<D>::name) {
    bounce_back.reset();
    removed = true;
  }
  return std::erase_if(body, [&](const auto& effect) { return name == effect->name(); }) > 0 || removed;
}

template <int D>
void Effects<D>::limits(const Scales<D>& scales, std::vector<StepLimit>& list) const {
  if (const auto* effect = std::get_if<Viscosity<D>>(&viscosity)) effect->limits(scales, list);
  const auto* noise = std::get_if<ThermalNoise<D>>(&thermal_noise);
  if (noise != nullptr && !implicit_friction) noise->limits(scales, list);
  for (const auto& effect : body) effect->limits(scales, list);
}

template <int D>
void Effects<D>::require_columns(State<D>& state) const {
  auto& store = state.particles;
  using Vec = base::Vec<D>;
  if (is_present(viscosity) || implicit_friction || is_present(thermal_noise))
    state.scaling = &store.template require<double>("scaling", "1");
  const auto* friction = std::get_if<Viscosity<D>>(&viscosity);
  if (friction != nullptr && friction->fourth_order)
    state.narrowing = &store.template require<double>("narrowing", "1/m^2");
  if (std::holds_alternative<DifferencePressure>(pressure)) {
    state.correction = &store.template require<base::Mat<D>>("correction", "1");
  }
  if (is_present(transport_velocity)) state.shift = &store.template require<Vec>("shift_velocity", "m/s");
  if (implicit_friction && !is_present(thermal_noise)) {
    state.driving = &store.template require<Vec>("driving", "m/s^2");
    state.start_velocity = &store.template require<Vec>("start_velocity", "m/s");
  }
  if (is_present(thermal_noise)) state.noise = &store.template require<Vec>("noise", "m/s^1.5");
}

template struct Effects<2>;
template struct Effects<3>;

}  // namespace shmoo::hydro
