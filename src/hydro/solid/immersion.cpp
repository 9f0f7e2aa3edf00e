#include "hydro/solid/immersion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/motion.hpp"

namespace shmoo::hydro {
namespace {

// How fast the acceleration that a solid shows the fluid follows its own, in steps. The fluid answers an acceleration
// like a mass of 0.6 density spacing per area of either face, so a body of m times its added mass would swing up at
// once for m < 1 if it showed its own; smoothed so, down to m = 1/19, a sheet of a twentieth of the fluid's density.
constexpr double following = 0.1;

}  // namespace

template <int D>
Immersion<D>::Immersion(const scene::Scene& scene, const sph::Filling<D>& filling) : solids_(scene, filling) {
  for (const auto& body : solids_.bodies()) {
    place_.emplace_back(body.size(), 0);
    acceleration_.emplace_back(body.size(), Vec(Vec::Zero()));
  }
}

template <int D>
void Immersion<D>::prepare(State<D>& state, const scene::Scene& scene) {
  if (empty()) return;
  if (scene.effects.thermal_noise) {
    throw base::InputError(
        "elastic solids do not take thermal noise; remove effects.thermal_noise, or make them walls");
  }
  if (scene.numerics.pressure == scene::PressureForm::difference) {
    throw base::InputError(
        "numerics.pressure = \"difference\" does not conserve momentum, so an elastic solid cannot answer it; "
        "remove it, or make the solids walls");
  }
  if (scene.numerics.viscous_step == scene::ViscousStep::implicit_step) {
    throw base::InputError(
        "numerics.viscous_step = \"implicit\" gives elastic solids no friction; remove it, or make the solids walls");
  }
  state.wall_velocity = &state.particles.template require<Vec>("wall_velocity", "m/s");
  state.wall_acceleration = &state.particles.template require<Vec>("wall_acceleration", "m/s^2");
  locate(state);
  show(state);
}

template <int D>
void Immersion<D>::locate(const State<D>& state) {
  if (empty()) return;
  std::vector<std::uint32_t> by_id;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    if (state.particles.role[i] != sph::Role::solid) continue;
    by_id.resize(std::max<std::size_t>(by_id.size(), state.particles.id[i] + 1));
    by_id[state.particles.id[i]] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t b = 0; b < place_.size(); ++b) {
    const auto& body = solids_.bodies()[b];
    for (std::size_t k = 0; k < body.size(); ++k) place_[b][k] = by_id[body.id[k]];
  }
}

template <int D>
void Immersion<D>::show(State<D>& state) const {
  for (std::size_t b = 0; b < place_.size(); ++b) {
    const auto& body = solids_.bodies()[b];
    for (std::size_t k = 0; k < body.size(); ++k) {
      const std::size_t i = place_[b][k];
      state.particles.position[i] = solids_.position(body, k);
      (*state.wall_velocity)[i] = body.velocity[k];
      (*state.wall_acceleration)[i] = acceleration_[b][k];
    }
  }
}

template <int D>
void Immersion<D>::advance(State<D>& state, double t, double dt) {
  if (empty()) return;
  std::vector<std::vector<Vec>> before;
  for (const auto& body : solids_.bodies()) before.push_back(body.velocity);
  solids_.advance(t, dt);
  for (std::size_t b = 0; b < place_.size(); ++b) {
    const auto& body = solids_.bodies()[b];
    for (std::size_t k = 0; k < body.size(); ++k) {
      const Vec own = (body.velocity[k] - before[b][k]) / dt + body.traction[k] / body.mass();
      acceleration_[b][k] += following * (own - acceleration_[b][k]);
    }
  }
  show(state);
}

template <int D>
void Immersion<D>::take_tractions(const State<D>& state) {
  for (std::size_t b = 0; b < place_.size(); ++b) {
    auto& body = solids_.bodies()[b];
    for (std::size_t k = 0; k < body.size(); ++k)
      body.traction[k] = state.scales.mass * state.acceleration[place_[b][k]];
  }
}

template <int D>
void Immersion<D>::recoil(const State<D>& state, const sph::AnyKernel<D>& any_kernel, const std::vector<Vec>& before) {
  std::vector<Vec> impulse;  // [kg m/s m^(D-3)] by place in the store; made where anything bounced
  const auto& near = state.rows.near_wall();
  for (std::size_t n = 0; n < near.size(); ++n) {
    const std::size_t i = near[n];
    const Vec lost = state.scales.mass * (before[n] - state.velocity[i]);
    if (lost.isZero(0.0)) continue;
    impulse.resize(state.particles.size(), Vec(Vec::Zero()));
    const auto weigh = [&](std::size_t j) {
      if (state.particles.role[j] == sph::Role::fluid || state.particles.role[j] == sph::Role::open) return 0.0;
      return std::visit([&](const auto& kernel) { return kernel.W(state.separation(i, j).norm()); }, any_kernel);
    };
    const std::uint64_t first = state.rows.first(i), end = first + state.rows.count(i);
    double sum = 0.0;
    for (std::uint64_t p = first; p < end; ++p) sum += weigh(std::size_t(state.rows.partner()[p]));
    for (std::uint64_t p = first; p < end && sum > 0.0; ++p) {
      const auto j = std::size_t(state.rows.partner()[p]);
      impulse[j] += weigh(j) / sum * lost;
    }
  }
  if (impulse.empty()) return;
  for (std::size_t b = 0; b < place_.size(); ++b) {
    auto& body = solids_.bodies()[b];
    for (std::size_t k = 0; k < body.size(); ++k)
      if (!body.held[k]) body.velocity[k] += impulse[place_[b][k]] / body.mass();
  }
}

// A body lighter than the fluid is shaken faster by it than fluid is.
template <int D>
void Immersion<D>::limits(const Scales<D>& scales, std::vector<StepLimit>& list) const {
  double lightest = 1.0;
  for (const auto& body : solids_.bodies()) lightest = std::min(lightest, body.density / scales.density);
  if (lightest >= 1.0) return;
  const double root = std::sqrt(lightest), nu = scales.kinematic_viscosity() + scales.bulk_viscosity / scales.density;
  list.push_back({"acoustic, at a light solid",
                  scales.courant * scales.smoothing * root / (scales.sound_speed + scales.speed),
                  fmt::format("the acoustic limit times sqrt({:g}), the ratio of densities", lightest)});
  if (nu > 0.0)
    list.push_back({"viscosity, at a light solid", 0.125 * scales.smoothing * scales.smoothing * lightest / nu,
                    fmt::format("the viscous limit times {:g}, the ratio of densities", lightest)});
}

template class Immersion<2>;
template class Immersion<3>;

}  // namespace shmoo::hydro
