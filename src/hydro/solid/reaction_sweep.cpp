#include "hydro/solid/reaction_sweep.hpp"

namespace shmoo::hydro {
namespace {

// A solid particle meets the fluid about it, eight particles at a time; pairs are seen from the fluid's side.
template <int D, class Kernel, class Pressure, class Friction>
class ReactionSweep {
 public:
  ReactionSweep(State<D>& state, const Kernel& kernel, const Pressure& pressure, const Friction& friction)
      : state_(state), kernel_(kernel), pressure_(pressure), friction_(friction) {}

  void particle(std::size_t solid) {
    Lane sum[D] = {};
    const std::int32_t* fluid = state_.rows.partner() + state_.rows.first(solid);
    const std::uint32_t count = state_.rows.count(solid);
    for (std::uint32_t k = 0; k < count; k += lanes) {
      ForcePair<D> pair;
      gather(solid, fluid + k, std::min<std::uint32_t>(lanes, count - k), pair);
      Lane radial = pressure_.coefficient(pair), relative{};
      if constexpr (present<Friction>) friction_.add(pair, radial, relative);
      for (int a = 0; a < D; ++a) {
        sum[a] = fma(radial, pair.x[a], sum[a]);
        if constexpr (present<Friction>) sum[a] = fma(relative, pair.v[a], sum[a]);
      }
    }
    for (int a = 0; a < D; ++a) {
      double total = 0.0;
      for (int l = 0; l < lanes; ++l) total += sum[a][l];
      state_.acceleration[solid][a] = -total / state_.scales.mass;
    }
  }

 private:
  // Lanes beyond `count` stand out of reach.
  void gather(std::size_t solid, const std::int32_t* fluid, std::uint32_t count, ForcePair<D>& pair) const {
    for (int a = 0; a < D; ++a) pair.x[a] = pair.v[a] = same(10.0 * state_.scales.reach);
    pair.V_i = pair.stress_i = pair.s = Lane{};
    const double own_scaling = state_.scaling ? (*state_.scaling)[solid] : 1.0;
    for (std::uint32_t l = 0; l < count; ++l) {
      const auto j = std::size_t(fluid[l]);
      const base::Vec<D> x = state_.separation(j, solid), v = state_.velocity[j] - state_.velocity[solid];
      for (int a = 0; a < D; ++a) {
        pair.x[a][l] = x[a];
        pair.v[a][l] = v[a];
      }
      pair.V_i[l] = state_.volume[j];
      pair.stress_i[l] = Pressure::stress(state_.pressure[j], state_.volume[j]);
      if (state_.scaling) pair.s[l] = 0.5 * ((*state_.scaling)[j] + own_scaling);
    }
    pair.r2 = same(tiny);
    for (int a = 0; a < D; ++a) pair.r2 = fma(pair.x[a], pair.x[a], pair.r2);
    pair.inverse_r = inverse_root(pair.r2);
    pair.F = kernel_.F(Lane(pair.r2 * pair.inverse_r));
    pair.V_j = state_.volume[solid];
    pair.stress_j = Pressure::stress(state_.pressure[solid], state_.volume[solid]);
  }

  State<D>& state_;
  const Kernel& kernel_;
  const Pressure& pressure_;
  Friction friction_;
};

}  // namespace

template <int D>
void sweep_reactions(State<D>& state, const sph::AnyKernel<D>& any_kernel, const Effects<D>& effects) {
  const auto is_solid = [&](std::size_t i) { return state.particles.role[i] == sph::Role::solid; };
  for (std::size_t i = 0; i < state.particles.size(); ++i)
    if (is_solid(i)) state.acceleration[i].setZero();
  const auto& near = state.rows.solid();
  std::visit(
      [&]<class Kernel, class Pressure, class Friction>(const Kernel& kernel, const Pressure& pressure,
                                                        const Friction& friction) {
        ReactionSweep<D, Kernel, Pressure, Friction> sweep(state, kernel, pressure, friction);
#pragma omp parallel for schedule(static) if (worth_threads(4 * near.size()))
        for (std::size_t n = 0; n < near.size(); ++n)
          if (is_solid(near[n])) sweep.particle(near[n]);
      },
      any_kernel, effects.pressure, effects.viscosity);
}

template void sweep_reactions(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&);
template void sweep_reactions(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&);

}  // namespace shmoo::hydro
