#include "hydro/force_sweep.hpp"

namespace shmoo::hydro {
namespace {

template <int D, class Pressure, class Friction, class Noise>
class ForceSweep {
 public:
  static constexpr bool scaled = present<Friction> || present<Noise>;

  ForceSweep(State<D>& state, const Friction& friction, const Noise& noise, std::uint64_t step)
      : state_(state), friction_(friction), noise_(noise), step_(step) {}

  // Returns the random numbers drawn for pairs in which this particle has the smaller id.
  std::uint64_t particle(std::size_t i) {
    Lane pressure[D] = {}, friction[D] = {};
    double impulse[D] = {};
    std::uint64_t draws = 0;
    for (std::uint64_t p = state_.rows.first(i); p < state_.rows.first(i + 1); p += lanes) {
      ForcePair<D> pair;
      load(i, p, pair);
      Lane coefficient;
      Pressure::coefficient(pair, coefficient);
      for (int a = 0; a < D; ++a) pressure[a] += coefficient * pair.x[a];
      if constexpr (present<Friction>) friction_.add(pair, friction);
      if constexpr (present<Noise>) draws += shake(i, p, pair, impulse);
    }
    finish(i, pressure, friction, impulse);
    return draws;
  }

 private:
  void load(std::size_t i, std::uint64_t p, ForcePair<D>& pair) const {
    const double* x = state_.particles.position[0].data();
    const double* v = state_.velocity[0].data();
    const std::int32_t* partner = state_.rows.partner() + p;
    pair.r2 = Lane{};
    for (int a = 0; a < D; ++a) {
      gather(pair.x[a], x, partner, D, a);
      pair.x[a] = x[D * i + std::size_t(a)] - pair.x[a];
      axes_[std::size_t(a)].to_nearest(pair.x[a]);
      pair.r2 += pair.x[a] * pair.x[a];
      gather(pair.v[a], v, partner, D, a);
      pair.v[a] = v[D * i + std::size_t(a)] - pair.v[a];
    }
    __builtin_memcpy(&pair.F, state_.rows.weight.data() + p, sizeof(pair.F));
    pair.V_i = state_.volume[i];
    gather(pair.V_j, state_.volume.values().data(), partner);
    pair.p_i = state_.pressure[i];
    gather(pair.p_j, state_.pressure.values().data(), partner);
    if constexpr (scaled) {
      const double* s = state_.scaling->values().data();
      gather(pair.s, s, partner);
      pair.s = 0.5 * (s[i] + pair.s);
    }
  }

  // The noise of the pairs in slots p .. p + lanes - 1.
  std::uint64_t shake(std::size_t i, std::uint64_t p, const ForcePair<D>& pair, double (&impulse)[D]) const {
    std::uint64_t draws = 0;
    const std::uint32_t id_i = state_.particles.id[i];
    for (int l = 0; l < lanes; ++l) {
      const auto j = std::size_t(state_.rows.partner()[p + std::uint64_t(l)]);
      if (j == i || !(pair.F[l] > 0.0)) continue;
      const std::uint32_t id_j = state_.particles.id[j];
      noise_.add(pair, l, step_, id_i, id_j, impulse);
      draws += id_i < id_j ? D : 0;
    }
    return draws;
  }

  void finish(std::size_t i, const Lane (&pressure)[D], const Lane (&friction)[D], const double (&impulse)[D]) {
    base::Vec<D> from_pressure, from_friction;
    for (int a = 0; a < D; ++a) {
      from_pressure[a] = total(pressure[a]);
      from_friction[a] = total(friction[a]);
    }
    if constexpr (Pressure::corrected) from_pressure = ((*state_.correction)[i] * from_pressure).eval();
    state_.acceleration[i] += (from_pressure + from_friction) / state_.scales.mass;
    if constexpr (present<Noise>) {
      for (int a = 0; a < D; ++a) (*state_.noise)[i][a] = impulse[a] / state_.scales.mass;
    }
  }

  State<D>& state_;
  const Friction& friction_;
  const Noise& noise_;
  std::uint64_t step_;
  std::array<Axis, D> axes_ = state_.rows.axes();
};

}  // namespace

template <int D>
std::uint64_t sweep_forces(State<D>& state, const Effects<D>& effects, std::uint64_t step) {
  const auto& fluid = state.rows.fluid();
  std::uint64_t draws = 0;
  std::visit(
      [&]<class Pressure, class Friction, class Noise>(const Pressure&, const Friction& friction, const Noise& noise) {
        ForceSweep<D, Pressure, Friction, Noise> sweep(state, friction, noise, step);
#pragma omp parallel for schedule(static) reduction(+ : draws) if (worth_threads(fluid.size()))
        for (std::size_t n = 0; n < fluid.size(); ++n) draws += sweep.particle(fluid[n]);
      },
      effects.pressure, effects.viscosity, effects.thermal_noise);
  return draws;
}

template std::uint64_t sweep_forces(State<2>&, const Effects<2>&, std::uint64_t);
template std::uint64_t sweep_forces(State<3>&, const Effects<3>&, std::uint64_t);

}  // namespace shmoo::hydro
