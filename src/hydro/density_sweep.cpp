#include "hydro/density_sweep.hpp"

#include <Eigen/LU>
#include <cmath>

namespace shmoo::hydro {
namespace {

// B = M^-1, M = sum_j V_j F x x^T, or 1 where a particle has too few neighbours for a correction. 1 is M's value for
// full support.
template <int D>
base::Mat<D> invert(const base::Mat<D>& second) {
  if (!(second.determinant() > 0.02)) return base::Mat<D>::Identity();
  return second.inverse();
}

template <int D, class Kernel, class Density, class Diffusion, class Transport>
class DensitySweep {
 public:
  DensitySweep(State<D>& state, const Kernel& kernel, const Density& density, const Diffusion& diffusion,
               const Transport& transport, double dt, double next_dt)
      : state_(state),
        kernel_(kernel),
        density_(density),
        diffusion_(diffusion),
        transport_(transport),
        dt_(dt),
        next_dt_(next_dt) {}

  void particle(std::size_t i) {
    Sums sums{};
    const double* x = state_.particles.position[0].data();
    const double* v = state_.velocity[0].data();
    const double* volume = state_.volume.values().data();
    const double* density = state_.density.values().data();
    for (std::uint64_t p = state_.rows.first(i); p < state_.rows.first(i + 1); p += lanes) {
      const std::int32_t* partner = state_.rows.partner() + p;
      DensityPair<D> pair;
      Lane r2{};
      for (int a = 0; a < D; ++a) {
        gather(pair.x[a], x, partner, D, a);
        pair.x[a] = x[D * i + std::size_t(a)] - pair.x[a];
        axes_[std::size_t(a)].to_nearest(pair.x[a]);
        r2 += pair.x[a] * pair.x[a];
        gather(pair.v[a], v, partner, D, a);
        pair.v[a] = v[D * i + std::size_t(a)] - pair.v[a];
      }
      double* weight = state_.rows.weight.data() + p;
      kernel_values(r2, weight);
      Lane F;
      __builtin_memcpy(&F, weight, sizeof(F));
      gather(pair.FV, volume, partner);
      pair.FV *= F;
      sums.add(pair);
      if constexpr (Density::summed) add_kernel(r2, partner, std::int32_t(i), sums.kernel);
      if constexpr (present<Diffusion>) {
        gather(pair.density, density, partner);
        pair.density -= density[i];
        Diffusion::add(pair, sums.diffusion);
      }
      if constexpr (present<Transport>) Transport::add(pair, sums.transport);
    }
    finish(i, sums);
  }

 private:
  struct Sums {
    Lane second[D][D], gradient[D][D];  // sum_j V_j F x x^T (a <= b), sum_j V_j F v_ij x_ij^T
    Lane diffusion[1], transport[D], kernel;

    void add(const DensityPair<D>& pair) {
      for (int a = 0; a < D; ++a) {
        const Lane Fx = pair.FV * pair.x[a];
        for (int b = a; b < D; ++b) second[a][b] += Fx * pair.x[b];
        for (int b = 0; b < D; ++b) gradient[b][a] += Fx * pair.v[b];
      }
    }
  };

  void kernel_values(const Lane& r2, double* weight) const {
    const Kernel kernel = kernel_;
    double distance2[lanes];
    __builtin_memcpy(distance2, &r2, sizeof(r2));
#pragma omp simd
    for (int l = 0; l < lanes; ++l) weight[l] = kernel.F(std::sqrt(distance2[l]));
  }

  // Adds W_ij, leaving out the padding.
  void add_kernel(const Lane& r2, const std::int32_t* partner, std::int32_t i, Lane& sum) const {
    double W[lanes];
    for (int l = 0; l < lanes; ++l) W[l] = partner[l] == i ? 0.0 : kernel_.W(std::sqrt(r2[l]));
    Lane values;
    __builtin_memcpy(&values, W, sizeof(values));
    sum += values;
  }

  double next_density(std::size_t i, const Sums& sums, double divergence) const {
    if constexpr (Density::summed) return density_.factor * (kernel_.W(0.0) + total(sums.kernel));
    double rate = -state_.density[i] * divergence;
    if constexpr (present<Diffusion>) rate += diffusion_.rate(sums.diffusion);
    return state_.density[i] + dt_ * rate;
  }

  void finish(std::size_t i, const Sums& sums) {
    base::Mat<D> second, raw;
    for (int a = 0; a < D; ++a) {
      for (int b = a; b < D; ++b) second(a, b) = second(b, a) = total(sums.second[a][b]);
      for (int b = 0; b < D; ++b) raw(b, a) = total(sums.gradient[b][a]);
    }
    const base::Mat<D> B = invert<D>(second);
    const base::Mat<D> gradient = raw * B;  // grad v, (a, b) = d v_a/d x_b
    state_.next_density[i] = next_density(i, sums, gradient.trace());
    if (state_.scaling) (*state_.scaling)[i] = D / std::max(second.trace(), 0.5 * D);
    if (state_.correction) (*state_.correction)[i] = B;
    if constexpr (present<Transport>) {
      const base::Vec<D> dv = transport_.shift(sums.transport, next_dt_);
      (*state_.shift)[i] = dv;
      state_.acceleration[i] = gradient * dv;
    } else {
      state_.acceleration[i].setZero();
    }
  }

  State<D>& state_;
  const Kernel& kernel_;
  const Density& density_;
  const Diffusion& diffusion_;
  const Transport& transport_;
  double dt_, next_dt_;
  std::array<Axis, D> axes_ = state_.rows.axes();
};

}  // namespace

template <int D>
void sweep_density(State<D>& state, const sph::AnyKernel<D>& any_kernel, const Effects<D>& effects, double dt,
                   double next_dt) {
  const auto& fluid = state.rows.fluid();
  std::visit(
      [&](const auto& kernel, const auto& density, const auto& diffusion, const auto& transport) {
        DensitySweep sweep(state, kernel, density, diffusion, transport, dt, next_dt);
#pragma omp parallel for schedule(static) if (worth_threads(fluid.size()))
        for (std::size_t n = 0; n < fluid.size(); ++n) sweep.particle(fluid[n]);
      },
      any_kernel, effects.density, effects.density_diffusion, effects.transport_velocity);
}

template void sweep_density(State<2>&, const sph::AnyKernel<2>&, const Effects<2>&, double, double);
template void sweep_density(State<3>&, const sph::AnyKernel<3>&, const Effects<3>&, double, double);

}  // namespace shmoo::hydro
