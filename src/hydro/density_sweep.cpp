#include "hydro/density_sweep.hpp"

#include <algorithm>

#include "hydro/lane_matrix.hpp"
#include "hydro/pair_reach.hpp"

namespace shmoo::hydro {
namespace {

// Below this determinant of the second moment, 1 for full support, a particle has too few neighbours for a correction.
constexpr double least_support = 0.02;
// Share of the second moment of full support, below which friction is of second order.
constexpr double full_support = 0.8;

// `narrowed`: takes the moments that friction of fourth order asks for.
template <int D, class Reach, class Density, class Diffusion, class Transport, bool narrowed = false>
class DensitySweep {
 public:
  DensitySweep(State<D>& state, const Reach& reach, const Density& density, const Diffusion& diffusion,
               const Transport& transport, double dt, double next_dt)
      : state_(state),
        reach_(reach),
        density_(density),
        diffusion_(diffusion),
        transport_(transport),
        dt_(dt),
        next_dt_(next_dt) {}

  void block(std::size_t b) {
    find_near(b);
    const Block& block = state_.rows.blocks[b];
    const std::int32_t* near = state_.rows.blocks.near(block);
    Own own;
    own.reach = reach_.own(b);
    for (int a = 0; a < D; ++a) {
      own.x[a] = load(coordinate(a) + lanes * b);
      own.v[a] = state_.slots.own_velocity(b, a);
    }
    if constexpr (present<Diffusion>) own.density = load(state_.slots.density.data() + lanes * b);
    Sums sums{};
    for (std::uint32_t k = 0; k < block.near; ++k) add(own, std::size_t(near[k]), sums);
    finish(b, sums);
  }

 private:
  struct Own {
    Lane x[D], v[D], density;
    [[no_unique_address]] typename Reach::Own reach;
  };
  struct Sums {
    Lane second[D][D];       // sum_j V_j F x x^T (a <= b)
    LaneMatrix<D> gradient;  // sum_j V_j F v_ij x_ij^T
    Lane diffusion[1], transport[D], kernel;
    Lane fourth, sixth;  // sum_j V_j F r^4 and r^6
  };

  const double* coordinate(int axis) const { return state_.rows.blocks.coordinate[std::size_t(axis)].data(); }

  // Of the partners, which lie within a skin of the reach, those within reach of one of the eight.
  void find_near(std::size_t b) {
    auto& blocks = state_.rows.blocks;
    Block& block = blocks[b];
    const std::int32_t* partners = blocks.partners(block);
    std::int32_t* near = blocks.near(block);
    const auto reach = reach_.own(b);
    Lane own[D];
    for (int a = 0; a < D; ++a) own[a] = load(coordinate(a) + lanes * b);
    std::uint32_t found = 0;
    for (std::uint32_t k = 0; k < block.partners; ++k) {
      const std::int32_t slot = partners[k];
      Lane r2{};
      for (int a = 0; a < D; ++a) {
        const Lane d = own[a] - coordinate(a)[slot];
        r2 = fma(d, d, r2);
      }
      near[found] = slot;
      found += reach_.any_within(r2, reach, std::size_t(slot));
    }
    block.near = found;
  }

  void add(const Own& own, std::size_t slot, Sums& sums) const {
    const auto& slots = state_.slots;
    DensityPair<D> pair;
    Lane r2 = same(tiny);
    for (int a = 0; a < D; ++a) {
      pair.x[a] = own.x[a] - coordinate(a)[slot];
      r2 = fma(pair.x[a], pair.x[a], r2);
      pair.v[a] = own.v[a] - slots.velocity[std::size_t(a)][slot];
    }
    const Lane r = pair.r = r2 * inverse_root(r2);
    const auto& kernel = reach_.of(own.reach, slot);
    pair.FV = kernel.F(r) * slots.volume[slot];
    for (int a = 0; a < D; ++a) {
      const Lane Fx = pair.FV * pair.x[a];
      for (int b = a; b < D; ++b) sums.second[a][b] = fma(Fx, pair.x[b], sums.second[a][b]);
      for (int b = 0; b < D; ++b) sums.gradient.at[b][a] = fma(Fx, pair.v[b], sums.gradient.at[b][a]);
    }
    if constexpr (narrowed) {
      const Lane moment = pair.FV * r2 * r2;
      sums.fourth += moment;
      sums.sixth = fma(moment, r2, sums.sixth);
    }
    if constexpr (Density::summed) sums.kernel += kernel.W(r);
    if constexpr (present<Diffusion>) {
      pair.density = slots.density[slot] - own.density;
      if constexpr (Reach::differ && Diffusion::by_reach) pair.density /= kernel.stretch;
      diffusion_.add(pair, sums.diffusion);
    }
    if constexpr (present<Transport>) Transport::add(pair, sums.transport);
  }

  // The friction's weights F (s - w r^2) have the exact second moment and no fourth one.
  void narrow(const Block& block, const Sums& sums, const Lane& second, Lane& scaling) {
    const Lane determinant = second * sums.sixth - sums.fourth * sums.fourth;
    const auto full = second > full_support * D;
    scaling = full ? D * sums.sixth / determinant : scaling;
    const Lane narrowing = full ? D * sums.fourth / determinant : Lane{};
    for (std::uint32_t l = 0; l < block.size; ++l) (*state_.narrowing)[block.first + l] = narrowing[l];
  }

  Lane next_density(const Block& block, const Sums& sums, const Lane& divergence) const {
    if constexpr (Density::summed) return density_.factor * sums.kernel;
    Lane now{};
    for (std::uint32_t l = 0; l < block.size; ++l) now[l] = state_.density[block.first + l];
    Lane rate = -now * divergence;
    if constexpr (present<Diffusion>) rate += diffusion_.rate(sums.diffusion);
    return now + dt_ * rate;
  }

  void shift(std::size_t b, const Sums& sums, Lane (&dv)[D]) const {
    if constexpr (Reach::differ)
      transport_.shift(sums.transport, next_dt_, reach_.own(b).smoothing / state_.scales.smoothing, dv);
    else
      transport_.shift(sums.transport, next_dt_, dv);
  }

  void finish(std::size_t b, const Sums& sums) {
    const Block& block = state_.rows.blocks[b];
    const auto B = symmetric_inverse<D>(sums.second, least_support);
    const auto gradient = product(sums.gradient, B);  // grad v, (a, b) = d v_a/d x_b
    const Lane density = next_density(block, sums, gradient.trace());
    Lane second = sums.second[0][0], dv[D], acceleration[D];
    for (int a = 1; a < D; ++a) second += sums.second[a][a];
    Lane scaling = D / larger(second, same(0.5 * D));
    // Volumes by summed densities do not fill the space that particles have: without this fluctuating fluids are too
    // thin.
    if constexpr (Density::summed) scaling *= density / state_.scales.density;
    if constexpr (narrowed) narrow(block, sums, second, scaling);
    if constexpr (present<Transport>) shift(b, sums, dv);
    for (int a = 0; a < D; ++a) {
      acceleration[a] = Lane{};
      if constexpr (present<Transport>) {
        for (int c = 0; c < D; ++c) acceleration[a] += gradient.at[a][c] * dv[c];
      }
    }
    for (std::uint32_t l = 0; l < block.size; ++l) {
      const std::size_t i = block.first + l;
      state_.density[i] = density[l];
      state_.volume[i] = reach_.mass(i) / density[l];
      state_.pressure[i] = state_.scales.pressure(density[l]);
      if (state_.scaling) (*state_.scaling)[i] = scaling[l];
      for (int a = 0; a < D; ++a) {
        state_.acceleration[i][a] = acceleration[a][l];
        if constexpr (present<Transport>) (*state_.shift)[i][a] = dv[a][l];
        if constexpr (Reach::differ)
          for (int c = 0; c < D; ++c) (*state_.gradient)[i](a, c) = gradient.at[a][c][l];
        if (!state_.correction) continue;
        for (int c = 0; c < D; ++c) (*state_.correction)[i](a, c) = B.at[a][c][l];
      }
    }
  }

  State<D>& state_;
  Reach reach_;
  const Density& density_;
  const Diffusion& diffusion_;
  const Transport& transport_;
  double dt_, next_dt_;
};

}  // namespace

template <int D>
void sweep_density(State<D>& state, const sph::AnyKernel<D>& any_kernel, const Effects<D>& effects, double dt,
                   double next_dt) {
  const std::size_t blocks = state.rows.blocks.size();
  const auto run = [&](auto&& sweep) {
#pragma omp parallel for schedule(static) if (worth_threads(lanes * blocks))
    for (std::size_t b = 0; b < blocks; ++b) sweep.block(b);
  };
  if constexpr (D == 2) {
    const auto refined = [&]<class Kernel>(const Kernel& kernel, const auto& diffusion, const auto& transport) {
      run(DensitySweep(state, MeanReach<D, Kernel>(state, kernel), DensityByContinuity{}, diffusion, transport, dt,
                       next_dt));
    };
    if (state.share) return std::visit(refined, any_kernel, effects.density_diffusion, effects.transport_velocity);
  }
  std::visit(
      [&]<class Kernel, class Density, class Diffusion, class Transport>(
          const Kernel& kernel, const Density& density, const Diffusion& diffusion, const Transport& transport) {
        using Reach = OneReach<D, Kernel>;
        const Reach reach(state, kernel);
        if constexpr (!Density::summed) {
          using Narrowed = DensitySweep<D, Reach, Density, Diffusion, Transport, true>;
          if (state.narrowing) return run(Narrowed(state, reach, density, diffusion, transport, dt, next_dt));
        }
        run(DensitySweep<D, Reach, Density, Diffusion, Transport>(state, reach, density, diffusion, transport, dt,
                                                                  next_dt));
      },
      any_kernel, effects.density, effects.density_diffusion, effects.transport_velocity);
}

template void sweep_density(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&, double, double);
template void sweep_density(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&, double, double);

}  // namespace shmoo::hydro
