#include "hydro/implicit_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "hydro/effects/thermal_noise.hpp"
#include "scene/motion.hpp"
#include "scene/refinement.hpp"

namespace shmoo::hydro {
namespace {

constexpr double tolerance = 1e-7;  // of the residual, relative to the right side
constexpr int most_rounds = 6, most_iterations = 200;
// An implicit step costs about as much as this many explicit ones.
constexpr double worth = 6.0;

template <int D, class Function>
void for_each_lane(const State<D>& state, Function&& function) {
  const std::size_t blocks = state.rows.blocks.size();
#pragma omp parallel for schedule(static) if (worth_threads(2 * blocks))
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t a = 0; a < D; ++a) function(a, lanes * b);
  }
}

}  // namespace

template <int D>
bool ImplicitFriction<D>::chosen(const scene::Scene& scene, const Scales<D>& scales) {
  if (!scene.effects.viscosity || !(scales.viscosity + scales.bulk_viscosity > 0.0)) return false;
  const bool wanted = scene.numerics.viscous_step == scene::ViscousStep::implicit_step;
  if (wanted && scene::has_mirrors(scene))
    throw base::InputError(
        "numerics.viscous_step = \"implicit\" does not know the mirror images of sides of type \"slip\"; remove it, or "
        "make these sides \"wall\" or \"periodic\"");
  if (scene.numerics.viscous_step != scene::ViscousStep::automatic) return wanted;
  if (scene::has_mirrors(scene) || scene::refined(scene)) return false;
  if (scene::has_solids(scene)) return false;  // they take the opposite of forces, not of such impulses
  std::vector<StepLimit> others, friction;
  list_base_limits(scales, others);
  Viscosity<D>{}.limits(scales, friction);
  if (scene.effects.thermal_noise) friction.push_back({"", ThermalNoise<D>::explicit_limit(scales), ""});
  double limit = friction.front().value;
  for (const auto& each : friction) limit = std::min(limit, each.value);
  return limit * worth < others.front().value;
}

template <int D>
void ImplicitFriction<D>::prepare(const State<D>& state, const sph::AnyKernel<D>& kernel) {
  for (Field* field : {&v_, &right_, &r_, &shadow_, &p_, &q_, &s_, &t_}) {
    for (auto& axis : *field) axis.resize(state.rows.blocks.slots());
  }
  matrix_.prepare(state, kernel);
}

template <int D>
void ImplicitFriction<D>::take(const State<D>& state, const std::vector<base::Vec<D>>& values, Field& field) const {
  const auto& blocks = state.rows.blocks;
  blocks.for_slots([&](std::size_t s, std::size_t i) {
    for (std::size_t a = 0; a < D && s < blocks.block_slots(); ++a) field[a][s] = values[i][int(a)];
  });
}

template <int D>
void ImplicitFriction<D>::give(const Field& field, State<D>& state) const {
  const auto& blocks = state.rows.blocks;
#pragma omp parallel for schedule(static) if (worth_threads(blocks.block_slots() / 4))
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (std::uint32_t l = 0; l < blocks[b].size; ++l) {
      for (std::size_t a = 0; a < D; ++a) state.velocity[blocks[b].first + l][int(a)] = field[a][lanes * b + l];
    }
  }
}

// Of images and solids.
template <int D>
void ImplicitFriction<D>::fill_others(State<D>& state, const RenewWalls& renew_walls, Field& v, bool linear) {
  const auto& blocks = state.rows.blocks;
  if (!state.rows.solid().empty()) {
    give(v, state);
    renew_walls();
  }
  blocks.for_others([&](std::size_t s, std::size_t i) {
    for (std::size_t a = 0; a < D; ++a) {
      const int axis = int(a);
      if (i < blocks.fluid())
        v[a][s] = v[a][blocks.slot(i)];
      else
        v[a][s] = state.velocity[i][axis] - (linear ? wall_at_rest_[i - blocks.fluid()][axis] : 0.0);
    }
  });
}

template <int D>
void ImplicitFriction<D>::apply(State<D>& state, const RenewWalls& renew_walls, double h, Field& v, Field& result,
                                bool linear) {
  fill_others(state, renew_walls, v, linear);
  matrix_.apply(state.rows.blocks, h, v, result);
}

// BiCGSTAB for the correction of v_ until the residual r_ is below `aim`; returns its norm.
template <int D>
double ImplicitFriction<D>::iterate(State<D>& state, const RenewWalls& renew_walls, double h, double aim) {
  double rho = 1.0, alpha = 1.0, omega = 1.0, left = norm(r_);
  shadow_ = r_;
  for (auto* field : {&p_, &q_})
    for (auto& axis : *field) std::fill(axis.begin(), axis.end(), 0.0);
  for (int k = 0; k < most_iterations && left > aim; ++k) {
    const double next = matrix_.product(shadow_, r_), beta = next / rho * (alpha / omega);
    rho = next;
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      const Lane p = load(p_[a].data() + s) - omega * load(q_[a].data() + s);
      store(load(r_[a].data() + s) + beta * p, p_[a].data() + s);
    });
    apply(state, renew_walls, h, p_, q_, true);
    alpha = rho / matrix_.product(shadow_, q_);
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      store(load(r_[a].data() + s) - alpha * load(q_[a].data() + s), s_[a].data() + s);
    });
    const bool done = norm(s_) <= aim;
    omega = 0.0;
    if (!done) {
      apply(state, renew_walls, h, s_, t_, true);
      omega = matrix_.product(t_, s_) / matrix_.product(t_, t_);
    }
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      const Lane rest = load(s_[a].data() + s), way = alpha * load(p_[a].data() + s) + omega * rest;
      store(load(v_[a].data() + s) + way, v_[a].data() + s);
      store(done ? rest : rest - omega * load(t_[a].data() + s), r_[a].data() + s);
    });
    left = norm(r_);
    if (done || !std::isfinite(left)) break;
  }
  return left;
}

// Rounds, because walls need not answer linearly.
template <int D>
void ImplicitFriction<D>::solve(State<D>& state, const RenewWalls& renew_walls, double h) {
  const bool walls = !state.rows.solid().empty();
  const double size = norm(right_);
  ++solutions_;
  if (walls) {
    const auto& blocks = state.rows.blocks;
    for (std::size_t i = 0; i < blocks.fluid(); ++i) state.velocity[i].setZero();
    renew_walls();
    wall_at_rest_.assign(state.velocity.values().begin() + std::ptrdiff_t(blocks.fluid()),
                         state.velocity.values().end());
    double moving = 0.0;
    for (const auto& u : wall_at_rest_) moving = std::max(moving, u.squaredNorm());
    if (size == 0.0 && moving == 0.0) return;
  }
  double left = 0.0, aim = tolerance * size;
  for (int round = 0; round < most_rounds; ++round) {
    apply(state, renew_walls, h, v_, t_, false);
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      store(load(right_[a].data() + s) - load(t_[a].data() + s), r_[a].data() + s);
    });
    left = norm(r_);
    aim = tolerance * std::max(size, norm(v_));
    if (left <= aim) return;
    if (round == 0) decline_ += std::log(left / aim);
    left = iterate(state, renew_walls, h, 0.5 * aim);
    if (!walls && left <= aim) return;
  }
  if (left <= 1e3 * aim) return;
  throw base::RunError(fmt::format(
      "the implicit viscous step did not converge: residual {:g} of {:g}; give numerics.viscous_step = \"explicit\"",
      left, aim));
}

template <int D>
void ImplicitFriction<D>::stage(State<D>& state, const RenewWalls& renew_walls, double h,
                                const std::vector<base::Vec<D>>& start) {
  const auto& blocks = state.rows.blocks;
  blocks.for_slots([&](std::size_t s, std::size_t i) {
    if (s >= blocks.block_slots()) return;
    for (std::size_t a = 0; a < D; ++a) right_[a][s] = start[i][int(a)] + h * source_[i][int(a)];
  });
  solve(state, renew_walls, h);
  give(v_, state);
  for (const std::uint32_t i : state.rows.fluid()) state.acceleration[i] = (state.velocity[i] - start[i]) / h;
}

template <int D>
void ImplicitFriction<D>::advance(State<D>& state, const RenewWalls& renew_walls, double dt) {
  const double gamma = 1.0 - std::sqrt(0.5);
  const auto& fluid = state.rows.fluid();
  source_.resize(fluid.size());
  start_.resize(fluid.size());
  for (const std::uint32_t i : fluid) {
    source_[i] = 0.5 * ((*state.driving)[i] + state.acceleration[i]);
    (*state.driving)[i] = state.acceleration[i];
  }
  take(state, state.velocity.values(), v_);
  stage(state, renew_walls, gamma * dt, state.start_velocity->values());
  for (const std::uint32_t i : fluid)
    start_[i] = (*state.start_velocity)[i] + (1.0 - gamma) * dt * state.acceleration[i];
  stage(state, renew_walls, gamma * dt, start_);
}

template <int D>
void ImplicitFriction<D>::describe(const Scales<D>& scales, double dt, std::vector<Derived>& list) const {
  std::vector<StepLimit> limits;
  Viscosity<D>{}.limits(scales, limits);
  list.push_back({"implicit viscosity, friction rate times step", scales.friction * dt, "1",
                  fmt::format("numerics.viscous_step; the explicit limit would be {:.3g} s", limits.front().value)});
}

// (1 + dt/2 G) v' = (1 - dt/2 G) v + sqrt(dt) noise.
template <int D>
void ImplicitFriction<D>::shake(State<D>& state, const RenewWalls& renew_walls, double dt) {
  const double h = 0.5 * dt, root = std::sqrt(dt);
  take(state, state.velocity.values(), v_);
  take(state, state.noise->values(), s_);
  apply(state, renew_walls, -h, v_, t_, false);
  for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
    store(load(t_[a].data() + s) + root * load(s_[a].data() + s), right_[a].data() + s);
  });
  solve(state, renew_walls, h);
  give(v_, state);
}

template class ImplicitFriction<2>;
template class ImplicitFriction<3>;

}  // namespace shmoo::hydro
