#include "hydro/implicit_friction.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/error.hpp"
#include "hydro/effects/thermal_noise.hpp"

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
  if (scene.numerics.viscous_step != scene::ViscousStep::automatic)
    return scene.numerics.viscous_step == scene::ViscousStep::implicit_step;
  std::vector<StepLimit> others, friction;
  list_base_limits(scales, others);
  Viscosity<D>{}.limits(scales, friction);
  if (scene.effects.thermal_noise) friction.push_back({"", ThermalNoise<D>::explicit_limit(scales), ""});
  double limit = friction.front().value;
  for (const auto& each : friction) limit = std::min(limit, each.value);
  return limit * worth < others.front().value;
}

template <int D>
void ImplicitFriction<D>::resize(const State<D>& state) {
  const auto& blocks = state.rows.blocks;
  for (Field* field : {&v_, &right_, &r_, &shadow_, &p_, &q_, &s_, &t_}) {
    for (auto& axis : *field) axis.resize(blocks.slots());
  }
  weight_.assign(blocks.block_slots(), 0.0);
  parts_.resize(blocks.size());
  first_.resize(blocks.size() + 1);
  first_[0] = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    first_[b + 1] = first_[b] + blocks[b].near;
    for (std::uint32_t l = 0; l < blocks[b].size; ++l) weight_[lanes * b + l] = 1.0;
  }
  across_.resize(lanes * first_.back());
  if (viscosity_.beta != 0.0) along_.resize(lanes * first_.back());
}

template <int D>
void ImplicitFriction<D>::prepare(const State<D>& state, const sph::AnyKernel<D>& any_kernel) {
  resize(state);
  const auto& blocks = state.rows.blocks;
  const auto& slots = state.slots;
  std::visit(
      [&](const auto& kernel) {
#pragma omp parallel for schedule(static) if (worth_threads(blocks.block_slots()))
        for (std::size_t b = 0; b < blocks.size(); ++b) {
          const std::int32_t* near = blocks.near(blocks[b]);
          const Lane volume = load(slots.volume.data() + lanes * b) / state.scales.mass;
          const Lane scaling = load(slots.scaling.data() + lanes * b);
          for (std::uint32_t k = 0; k < blocks[b].near; ++k) {
            const auto slot = std::size_t(near[k]);
            Lane r2 = same(tiny);
            for (std::size_t a = 0; a < D; ++a) {
              const Lane x = load(blocks.coordinate[a].data() + lanes * b) - blocks.coordinate[a][slot];
              r2 = fma(x, x, r2);
            }
            const Lane inverse_r = inverse_root(r2);
            const Lane F = kernel.F(Lane(r2 * inverse_r));
            const Lane common = volume * slots.volume[slot] * F * (0.5 * (scaling + slots.scaling[slot]));
            const std::size_t at = lanes * (first_[b] + k);
            store(viscosity_.alpha * common, across_.data() + at);
            if (viscosity_.beta == 0.0) continue;
            const Lane inverse2 = inverse_r * inverse_r;
            store(r2 > 1e-200 ? viscosity_.beta * common * inverse2 : Lane{}, along_.data() + at);
          }
        }
      },
      any_kernel);
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
  ++products_;
  const auto& blocks = state.rows.blocks;
  const bool has_along = viscosity_.beta != 0.0;
#pragma omp parallel for schedule(static) if (worth_threads(blocks.block_slots()))
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::int32_t* near = blocks.near(blocks[b]);
    Lane own[D], sum[D] = {};
    for (std::size_t a = 0; a < D; ++a) own[a] = load(v[a].data() + lanes * b);
    for (std::uint32_t k = 0; k < blocks[b].near; ++k) {
      const auto slot = std::size_t(near[k]);
      const std::size_t at = lanes * (first_[b] + k);
      const Lane across = load(across_.data() + at);
      Lane dv[D];
      for (std::size_t a = 0; a < D; ++a) {
        dv[a] = own[a] - v[a][slot];
        sum[a] = fma(across, dv[a], sum[a]);
      }
      if (!has_along) continue;
      Lane x[D], projected{};
      for (std::size_t a = 0; a < D; ++a) {
        x[a] = load(blocks.coordinate[a].data() + lanes * b) - blocks.coordinate[a][slot];
        projected = fma(x[a], dv[a], projected);
      }
      projected *= load(along_.data() + at);
      for (std::size_t a = 0; a < D; ++a) sum[a] = fma(projected, x[a], sum[a]);
    }
    for (std::size_t a = 0; a < D; ++a) store(fma(same(h), sum[a], own[a]), result[a].data() + lanes * b);
  }
}

// Summed in the order of blocks, so that bits do not depend on threads.
template <int D>
double ImplicitFriction<D>::product(const State<D>& state, const Field& a, const Field& b) {
#pragma omp parallel for schedule(static) if (worth_threads(2 * parts_.size()))
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Lane sum{};
    for (std::size_t c = 0; c < D; ++c) sum = fma(load(a[c].data() + lanes * k), load(b[c].data() + lanes * k), sum);
    sum *= load(weight_.data() + lanes * k);
    parts_[k] = ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7]));
  }
  double total = 0.0;
  for (std::size_t k = 0; k < state.rows.blocks.size(); ++k) total += parts_[k];
  return total;
}

// BiCGSTAB for the correction of v_ until the residual r_ is below `aim`; returns its norm.
template <int D>
double ImplicitFriction<D>::iterate(State<D>& state, const RenewWalls& renew_walls, double h, double aim) {
  double rho = 1.0, alpha = 1.0, omega = 1.0, left = std::sqrt(product(state, r_, r_));
  shadow_ = r_;
  for (auto* field : {&p_, &q_})
    for (auto& axis : *field) std::fill(axis.begin(), axis.end(), 0.0);
  for (int k = 0; k < most_iterations && left > aim; ++k) {
    const double next = product(state, shadow_, r_), beta = next / rho * (alpha / omega);
    rho = next;
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      const Lane p = load(p_[a].data() + s) - omega * load(q_[a].data() + s);
      store(load(r_[a].data() + s) + beta * p, p_[a].data() + s);
    });
    apply(state, renew_walls, h, p_, q_, true);
    alpha = rho / product(state, shadow_, q_);
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      store(load(r_[a].data() + s) - alpha * load(q_[a].data() + s), s_[a].data() + s);
    });
    const bool done = std::sqrt(product(state, s_, s_)) <= aim;
    omega = 0.0;
    if (!done) {
      apply(state, renew_walls, h, s_, t_, true);
      omega = product(state, t_, s_) / product(state, t_, t_);
    }
    for_each_lane<D>(state, [&](std::size_t a, std::size_t s) {
      const Lane rest = load(s_[a].data() + s), way = alpha * load(p_[a].data() + s) + omega * rest;
      store(load(v_[a].data() + s) + way, v_[a].data() + s);
      store(done ? rest : rest - omega * load(t_[a].data() + s), r_[a].data() + s);
    });
    left = std::sqrt(product(state, r_, r_));
    if (done || !std::isfinite(left)) break;
  }
  return left;
}

// Rounds, because walls need not answer linearly.
template <int D>
void ImplicitFriction<D>::solve(State<D>& state, const RenewWalls& renew_walls, double h) {
  const bool walls = !state.rows.solid().empty();
  const double size = std::sqrt(product(state, right_, right_));
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
    left = std::sqrt(product(state, r_, r_));
    aim = tolerance * std::max(size, std::sqrt(product(state, v_, v_)));
    if (left <= aim) return;
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

template <int D>
std::size_t ImplicitFriction<D>::bytes() const {
  return sizeof(double) * (across_.size() + along_.size() + weight_.size() + 8 * D * v_[0].size());
}

template class ImplicitFriction<2>;
template class ImplicitFriction<3>;

}  // namespace shmoo::hydro
