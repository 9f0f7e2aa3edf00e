#include "hydro/fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "hydro/density_sweep.hpp"
#include "hydro/effects/buoyancy.hpp"
#include "hydro/force_sweep.hpp"
#include "hydro/initial_velocity.hpp"
#include "hydro/solid/reaction_sweep.hpp"
#include "scene/motion.hpp"
#include "scene/refinement.hpp"

namespace shmoo::hydro {
namespace {

constexpr double most_movement = 0.25;  // [spacings] of any particle in one step

}  // namespace

template <int D>
Fluid<D>::Fluid(const scene::Scene& scene, sph::Filling<D>&& filling, Bare)
    : solids_(scene, filling),
      open_(scene::has_open_sides(scene) ? std::make_optional<OpenSides<D>>(scene, filling) : std::nullopt),
      spacings_(scene::refined(scene) ? std::make_optional<Spacings<D>>(scene) : std::nullopt),
      places_(scene::particles_come_and_go(scene) ? std::make_optional<Places>(filling) : std::nullopt),
      mirrors_(filling.mirrors),
      enclosed_(!open_ && is_enclosed(filling)),
      covered_(is_covered(scene, filling)),
      state_(std::move(filling), derive_scales<D>(scene, filling, derived_)),
      kernel_(sph::make_kernel<D>(scene.numerics.kernel, state_.scales.reach)),
      walls_(scene),
      guard_(scene) {}

template <int D>
Fluid<D>::Fluid(const scene::Scene& scene, sph::Filling<D> filling, const base::RandomKey& key)
    : Fluid(scene, std::move(filling), Bare{}) {
  effects_ = Effects<D>::choose(scene, state_.scales, key);
  initialise(scene);
}

template <int D>
Fluid<D>::Fluid(const scene::Scene& scene, sph::Filling<D> filling, Effects<D> effects)
    : Fluid(scene, std::move(filling), Bare{}) {
  effects_ = std::move(effects);
  initialise(scene);
}

template <int D>
void Fluid<D>::initialise(const scene::Scene& scene) {
  effects_.require_columns(state_);
  for (const auto& axis : mirrors_) any_mirror_ = any_mirror_ || axis[0] || axis[1];
  auto& particles = state_.particles;
  if (spacings_) spacings_->prepare(state_);
  if (places_) places_->prepare(particles);
  const InitialVelocity<D> initial(scene);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    state_.density[i] = state_.scales.density;
    state_.volume[i] = state_.mass(i) / state_.scales.density;
    state_.pressure[i] = state_.scales.background;
    if (particles.role[i] == sph::Role::fluid) state_.velocity[i] = initial(particles.position[i]);
  }
  walls_.prepare(state_, scene);
  solids_.prepare(state_, scene);
  if (!enclosed_) effects_.closed_room.reset();
  if (!covered_) effects_.density_tie.reset();
  if (effects_.closed_room) effects_.closed_room->prepare(state_, solids_.solids().volume());
  find_step();
  restart();
}

template <int D>
void Fluid<D>::find_step() {
  const auto finest = state_.scales.of_finest();
  list_base_limits(finest, limits_);
  effects_.limits(finest, limits_);
  solids_.limits(state_.scales, limits_);
  const auto smallest = std::min_element(limits_.begin(), limits_.end(),
                                         [](const StepLimit& a, const StepLimit& b) { return a.value < b.value; });
  dt_ = smallest->value;
  for (const auto& limit : limits_) derived_.push_back({"step limit, " + limit.name, limit.value, "s", limit.why});
  derived_.push_back({"time step", dt_, "s", "set by: " + smallest->name});
  if (effects_.implicit_friction) effects_.implicit_friction->describe(state_.scales, dt_, derived_);
  for (const auto& effect : effects_.body) effect->describe(derived_);
  solids_.solids().describe(derived_);
}

template <int D>
void Fluid<D>::restart() {
  auto& particles = state_.particles;
  fastest_ = 0.0;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.role[i] != sph::Role::fluid) continue;
    particles.position[i] = state_.box.wrap(particles.position[i]);
    state_.volume[i] = state_.mass(i) / state_.density[i];
    state_.pressure[i] = state_.scales.pressure(state_.density[i]);
    fastest_ = std::max(fastest_, state_.velocity[i].squaredNorm());
  }
  fastest_ = std::sqrt(fastest_);
  rebuild();
  last_dt_ = dt_;
  evaluate(0.0);
  if (state_.driving) state_.driving->values() = state_.acceleration.values();
}

template <int D>
void Fluid<D>::rebuild() {
  if (open_) open_->exchange(state_, *places_, time_);
  if (spacings_) spacings_->exchange(state_, *places_);
  state_.rows.build(state_.particles, state_.smoothing ? &state_.smoothing->values() : nullptr);
  solids_.locate(state_);
  if (open_) open_->locate(state_);
}

template <int D>
double Fluid<D>::step_limit() const {
  const double movement = most_movement * state_.scales.finest;
  return fastest_ * dt_ > movement ? movement / fastest_ : dt_;
}

template <int D>
void Fluid<D>::advance(double until) {
  while (time_ < until) {
    const double rest = until - time_;
    const double steps = std::ceil(rest / step_limit() * (1.0 - 1e-9));
    step(rest / std::max(steps, 1.0));
    if (steps <= 1.0) time_ = until;
  }
}

// One step: half a kick, a drift, new rates and forces at the new positions (with the half-step velocities, so that
// each pair is visited once a step in either sweep), half a kick, and what crossed a wall is thrown back.
template <int D>
void Fluid<D>::step(double dt) {
  const bool implicit = effects_.implicit_friction.has_value();
  const double root = implicit ? 0.0 : std::sqrt(dt), last_root = implicit ? 0.0 : std::sqrt(last_dt_);
  if (state_.start_velocity) state_.start_velocity->values() = state_.velocity.values();
  kick(dt, 0.5 * (root + last_root));
  last_dt_ = dt;
  solids_.push(0.5 * dt);
  drift(dt);
  if (any_mirror_) reflect();
  if (open_) open_->carry(state_, dt);
  walls_.carry(state_, time_, dt);
  solids_.advance(state_, time_, dt);
  time_ += dt;
  if (effects_.bounce_back) bounces_ += guard_.apply(state_, walls_.motion(), time_, dt);
  ++steps_;
  if (!state_.rows.follow(state_.particles)) rebuild();
  evaluate(dt);
  implicit ? rub(dt) : kick(dt, root);
  solids_.push(0.5 * dt);
  if (effects_.bounce_back && !solids_.empty()) bounce();
  check();
}

template <int D>
void Fluid<D>::reflect() {
  for (int a = 0; a < D; ++a) {
    for (int side = 0; side < 2; ++side) {
      if (!mirrors_[std::size_t(a)][std::size_t(side)]) continue;
      const double plane = (side == 0 ? state_.box.lower : state_.box.upper)[a], out = side == 0 ? -1.0 : 1.0;
      for (const std::uint32_t i : state_.rows.fluid()) {
        double& x = state_.particles.position[i][a];
        if (!(out * (x - plane) > 0.0)) continue;
        x = 2.0 * plane - x;
        state_.velocity[i][a] = -state_.velocity[i][a];
      }
    }
  }
}

template <int D>
void Fluid<D>::bounce() {
  std::vector<Vec> before;
  if (!solids_.empty())
    for (const std::uint32_t i : state_.rows.near_wall()) before.push_back(state_.velocity[i]);
  const auto bounced = effects_.bounce_back->apply(state_, kernel_);
  if (bounced > 0 && !solids_.empty()) solids_.recoil(state_, kernel_, before);
  bounces_ += bounced;
}

template <int D>
void Fluid<D>::evaluate(double dt) {
  const double next = dt > 0.0 ? dt : dt_;
  walls_.extrapolate_velocity(state_, kernel_, time_);
  if (open_) open_->set_velocity(state_, kernel_, time_, dt);
  fill_slots();
  if (effects_.shepard_filter && dt > 0.0 && effects_.shepard_filter->due(steps_)) {
    effects_.shepard_filter->apply(state_, kernel_);
    fill_slots();
  }
  sweep_density(state_, kernel_, effects_, dt, next);
  const double solids = solids_.solids().volume();
  if (effects_.closed_room && dt > 0.0 && effects_.closed_room->due(steps_, solids))
    effects_.closed_room->apply(state_, solids);
  if (effects_.density_tie && dt > 0.0 && effects_.density_tie->due(steps_))
    effects_.density_tie->apply(state_, kernel_, dt);
  walls_.extrapolate_pressure(state_, time_);
  if (open_) open_->set_pressure(state_, kernel_);
  fill_stress();
  draws_ += sweep_forces(state_, kernel_, effects_, evaluations_++);
  if (!solids_.empty()) {
    sweep_reactions(state_, kernel_, effects_);
    solids_.take_tractions(state_);
  }
  const BodyView<D> view{state_.particles.position.values(), state_.velocity.values(), state_.acceleration.values(),
                         state_.particles.id.values(), next};
  const std::span<const std::uint32_t> fluid = state_.rows.fluid();
  constexpr std::size_t chunk = 1024;
#pragma omp parallel for schedule(static) if (worth_threads(fluid.size() / 4))
  for (std::size_t first = 0; first < fluid.size(); first += chunk) {
    const auto range = fluid.subspan(first, std::min(chunk, fluid.size() - first));
    for (const auto& effect : effects_.body) effect->apply(view, range);
  }
}

// Half a step of acceleration. The noise of an evaluation acts in two halves, one before and one after the velocity is
// seen: so the seen velocity has the exact temperature for any friction (each is the mean of two leapfrog velocities).
template <int D>
void Fluid<D>::kick(double dt, double root) {
  const auto& fluid = state_.rows.fluid();
  double fastest = 0.0;
#pragma omp parallel for schedule(static) reduction(max : fastest) if (worth_threads(fluid.size() / 4))
  for (std::size_t n = 0; n < fluid.size(); ++n) {
    const std::size_t i = fluid[n];
    Vec v = state_.velocity[i] + 0.5 * dt * state_.acceleration[i];
    if (state_.noise) v += 0.5 * root * (*state_.noise)[i];
    state_.velocity[i] = v;
    const double speed2 = v.squaredNorm();
    fastest = speed2 >= 0.0 ? std::max(fastest, speed2) : std::numeric_limits<double>::infinity();
  }
  fastest_ = std::sqrt(fastest);
}

template <int D>
void Fluid<D>::rub(double dt) {
  auto& friction = *effects_.implicit_friction;
  const auto renew_walls = [this] { walls_.extrapolate_velocity(state_, kernel_, time_); };
  friction.prepare(state_, kernel_);
  if (state_.noise) {
    kick(dt, 0.0);
    friction.shake(state_, renew_walls, dt);
  } else {
    friction.advance(state_, renew_walls, dt);
  }
  renew_walls();
  double fastest = 0.0;
  for (const std::uint32_t i : state_.rows.fluid()) {
    const double speed2 = state_.velocity[i].squaredNorm();
    fastest = speed2 >= 0.0 ? std::max(fastest, speed2) : std::numeric_limits<double>::infinity();
  }
  fastest_ = std::sqrt(fastest);
}

template <int D>
void Fluid<D>::drift(double dt) {
  const auto& fluid = state_.rows.fluid();
#pragma omp parallel for schedule(static) if (worth_threads(fluid.size() / 4))
  for (std::size_t n = 0; n < fluid.size(); ++n) {
    const std::size_t i = fluid[n];
    Vec transport = state_.velocity[i];
    if (state_.shift) transport += (*state_.shift)[i];
    state_.particles.position[i] = state_.box.wrap(state_.particles.position[i] + dt * transport);
    if (state_.mean_velocity) (*state_.mean_velocity)[i] += dt * state_.velocity[i];
    if (state_.mean_shift) (*state_.mean_shift)[i] += dt * (*state_.shift)[i];
  }
  interval_ += dt;
}

template <int D>
void Fluid<D>::check() const {
  if (fastest_ < 100.0 * (state_.scales.sound_speed + state_.scales.speed)) return;
  throw base::RunError(
      fmt::format("the flow blew up at t = {:g} s, step {}: the fastest particle has {:g} m/s, the speed of "
                  "sound is {:g} m/s. Give a larger flow.reference_speed, a smaller numerics.courant, or a "
                  "smaller spacing.",
                  time_, steps_, fastest_, state_.scales.sound_speed));
}

template <int D>
void Fluid<D>::buoy(const std::vector<double>& lightness) {
  for (const auto& effect : effects_.body) {
    if (auto* buoyancy = dynamic_cast<Buoyancy<D>*>(effect.get())) buoyancy->set(lightness);
  }
  if (steps_ == 0) restart();  // the first half kick feels it, too
}

template class Fluid<2>;
template class Fluid<3>;

}  // namespace shmoo::hydro
