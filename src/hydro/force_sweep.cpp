#include "hydro/force_sweep.hpp"

#include <optional>

#include "hydro/pair_reach.hpp"

namespace shmoo::hydro {
namespace {

template <int D, class Reach, class Pressure, class Friction, class Noise>
class ForceSweep {
 public:
  static constexpr bool scaled = present<Friction> || present<Noise>;
  static constexpr bool narrowed = std::is_same_v<Friction, ViscosityNarrowed<D>>;
  static constexpr bool sees_velocity = present<Friction> || Pressure::sees_velocity;
  using Ids = base::LaneRandom::Words;

  ForceSweep(State<D>& state, const Reach& reach, const Pressure& pressure, const Friction& friction,
             const Noise& noise, std::uint64_t step)
      : state_(state), reach_(reach), pressure_(pressure), friction_(friction), noise_(noise) {
    if constexpr (present<Noise>) random_ = noise.at(step);
  }

  // Returns the random numbers drawn for pairs in which a particle of this block has the smaller id.
  std::uint64_t block(std::size_t b) {
    const auto& blocks = state_.rows.blocks;
    const std::int32_t* near = blocks.near(blocks[b]);
    const Own own = load_own(b);
    Sums sums{};
    for (std::uint32_t k = 0; k < blocks[b].near; ++k) {
      const auto slot = std::size_t(near[k]);
      ForcePair<D> pair;
      load_pair(own, slot, pair);
      Lane radial = pressure_.coefficient(pair), relative{};
      if constexpr (Pressure::corrected) {
        for (int a = 0; a < D; ++a) sums.pressure[a] = fma(radial, pair.x[a], sums.pressure[a]);
        radial = Lane{};
      }
      if constexpr (present<Friction>) friction_.add(pair, radial, relative);
      for (int a = 0; a < D; ++a) {
        if constexpr (present<Friction> || !Pressure::corrected) sums.force[a] = fma(radial, pair.x[a], sums.force[a]);
        if constexpr (present<Friction>) sums.force[a] = fma(relative, pair.v[a], sums.force[a]);
      }
      if constexpr (present<Noise>) shake(own, slot, pair, sums);
    }
    return finish(blocks[b], sums);
  }

 private:
  struct Own {
    Lane x[D], v[D], volume, stress, scaling, narrowing;
    Ids id;
    [[no_unique_address]] typename Reach::Own reach;
  };
  struct Sums {
    Lane force[D], pressure[D], impulse[D];
    Ids draws;
  };

  Own load_own(std::size_t b) const {
    const auto& slots = state_.slots;
    const std::size_t first = lanes * b;
    Own own;
    own.reach = reach_.own(b);
    for (int a = 0; a < D; ++a) {
      own.x[a] = load(coordinate(a) + first);
      own.v[a] = slots.own_velocity(b, a);
    }
    own.volume = load(slots.volume.data() + first);
    own.stress = load(slots.stress.data() + first);
    if constexpr (scaled) own.scaling = load(slots.scaling.data() + first);
    if constexpr (narrowed) own.narrowing = load(slots.narrowing.data() + first);
    if constexpr (present<Noise>) {
      for (std::size_t l = 0; l < lanes; ++l) own.id[l] = slots.id[first + l];
    }
    return own;
  }

  void load_pair(const Own& own, std::size_t slot, ForcePair<D>& pair) const {
    const auto& slots = state_.slots;
    pair.r2 = same(tiny);
    for (int a = 0; a < D; ++a) {
      pair.x[a] = own.x[a] - coordinate(a)[slot];
      pair.r2 = fma(pair.x[a], pair.x[a], pair.r2);
      if constexpr (sees_velocity) pair.v[a] = own.v[a] - slots.velocity[std::size_t(a)][slot];
    }
    pair.inverse_r = inverse_root(pair.r2);
    pair.F = reach_.of(own.reach, slot).F(Lane(pair.r2 * pair.inverse_r));
    pair.V_i = own.volume;
    pair.V_j = slots.volume[slot];
    pair.stress_i = own.stress;
    pair.stress_j = slots.stress[slot];
    if constexpr (scaled) pair.s = 0.5 * (own.scaling + slots.scaling[slot]);
    if constexpr (narrowed) pair.s = less_product(pair.s, 0.5 * (own.narrowing + slots.narrowing[slot]), pair.r2);
  }

  void shake(const Own& own, std::size_t slot, const ForcePair<D>& pair, Sums& sums) const {
    const std::uint32_t id = state_.slots.id[slot];
    noise_.add(pair, *random_, own.id, id, sums.impulse);
    sums.draws += Ids((pair.F > 0.0) & (own.id < id)) & (Ids{} + std::uint64_t(D));
  }

  std::uint64_t finish(const Block& block, const Sums& sums) {
    std::uint64_t draws = 0;
    for (std::uint32_t l = 0; l < block.size; ++l) {
      const std::size_t i = block.first + l;
      const double mass = reach_.mass(i);
      base::Vec<D> force, pressure;
      for (int a = 0; a < D; ++a) {
        force[a] = sums.force[a][l];
        pressure[a] = sums.pressure[a][l];
        if constexpr (present<Noise>) (*state_.noise)[i][a] = sums.impulse[a][l] / mass;
      }
      if constexpr (Pressure::corrected) force += (*state_.correction)[i] * pressure;
      state_.acceleration[i] += force / mass;
      draws += sums.draws[l];
    }
    return draws;
  }

  const double* coordinate(int axis) const { return state_.rows.blocks.coordinate[std::size_t(axis)].data(); }

  State<D>& state_;
  Reach reach_;
  const Pressure& pressure_;
  Friction friction_;
  const Noise& noise_;
  std::optional<base::LaneRandom> random_;
};

}  // namespace

template <int D>
std::uint64_t sweep_forces(State<D>& state, const sph::AnyKernel<D>& any_kernel, const Effects<D>& effects,
                           std::uint64_t step) {
  const std::size_t blocks = state.rows.blocks.size();
  std::uint64_t draws = 0;
  const auto run = [&]<class Sweep>(Sweep&& sweep) {
#pragma omp parallel for schedule(static) reduction(+ : draws) if (worth_threads(lanes * blocks))
    for (std::size_t b = 0; b < blocks; ++b) draws += sweep.block(b);
  };
  if constexpr (D == 2) {
    const auto refined = [&]<class Kernel, class Pressure, class Friction>(
                             const Kernel& kernel, const Pressure& pressure, const Friction& friction) {
      const auto form = by_volume(pressure);
      using Reach = MeanReach<D, Kernel>;
      run(ForceSweep<D, Reach, std::decay_t<decltype(form)>, Friction, Absent>(state, Reach(state, kernel), form,
                                                                               friction, {}, step));
    };
    if (state.share) {
      std::visit(refined, any_kernel, effects.pressure, effects.viscosity);
      return draws;
    }
  }
  std::visit(
      [&]<class Kernel, class Pressure, class Friction, class Noise>(const Kernel& kernel, const Pressure& pressure,
                                                                     const Friction& friction, const Noise& noise) {
        using Reach = OneReach<D, Kernel>;
        const Reach reach(state, kernel);
        const auto with = [&]<class Form>(const Form& form) {
          run(ForceSweep<D, Reach, Pressure, Form, Noise>(state, reach, pressure, form, noise, step));
        };
        if constexpr (present<Friction> && !present<Noise>) {
          if (state.narrowing) return with(ViscosityNarrowed<D>{{friction.alpha}});
          if (friction.beta == 0.0) return with(ViscosityAcross<D>{friction.alpha});
        }
        with(friction);
      },
      any_kernel, effects.pressure, effects.viscosity, effects.thermal_noise);
  return draws;
}

template std::uint64_t sweep_forces(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&, std::uint64_t);
template std::uint64_t sweep_forces(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&, std::uint64_t);

}  // namespace shmoo::hydro
