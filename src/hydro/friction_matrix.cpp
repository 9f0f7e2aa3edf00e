#include "hydro/friction_matrix.hpp"

namespace shmoo::hydro {

template <int D>
void FrictionMatrix<D>::resize(const Blocks<D>& blocks) {
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
void FrictionMatrix<D>::prepare(const State<D>& state, const sph::AnyKernel<D>& any_kernel) {
  resize(state.rows.blocks);
  std::visit(
      [&](const auto& kernel) {
#pragma omp parallel for schedule(static) if (worth_threads(weight_.size()))
        for (std::size_t b = 0; b < parts_.size(); ++b) prepare_block(state, kernel, b);
      },
      any_kernel);
}

template <int D>
template <class Kernel>
void FrictionMatrix<D>::prepare_block(const State<D>& state, const Kernel& kernel, std::size_t b) {
  const auto& blocks = state.rows.blocks;
  const auto& slots = state.slots;
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
    // Of a particle with itself: none.
    const Lane along = viscosity_.beta * common * (inverse_r * inverse_r);
    store(r2 > 1e3 * tiny ? along : Lane{}, along_.data() + at);
  }
}

template <int D>
void FrictionMatrix<D>::apply(const Blocks<D>& blocks, double h, const Field& v, Field& result) {
  const bool has_along = viscosity_.beta != 0.0;
#pragma omp parallel for schedule(static) if (worth_threads(blocks.block_slots()))
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const std::int32_t* near = blocks.near(blocks[b]);
    Lane own[D], x_own[D], sum[D] = {};
    for (std::size_t a = 0; a < D; ++a) {
      own[a] = load(v[a].data() + lanes * b);
      x_own[a] = load(blocks.coordinate[a].data() + lanes * b);
    }
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
        x[a] = x_own[a] - blocks.coordinate[a][slot];
        projected = fma(x[a], dv[a], projected);
      }
      projected *= load(along_.data() + at);
      for (std::size_t a = 0; a < D; ++a) sum[a] = fma(projected, x[a], sum[a]);
    }
    for (std::size_t a = 0; a < D; ++a) store(fma(same(h), sum[a], own[a]), result[a].data() + lanes * b);
  }
}

template <int D>
double FrictionMatrix<D>::product(const Field& a, const Field& b) {
#pragma omp parallel for schedule(static) if (worth_threads(2 * parts_.size()))
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Lane sum{};
    for (std::size_t c = 0; c < D; ++c) sum = fma(load(a[c].data() + lanes * k), load(b[c].data() + lanes * k), sum);
    sum *= load(weight_.data() + lanes * k);
    parts_[k] = ((sum[0] + sum[4]) + (sum[1] + sum[5])) + ((sum[2] + sum[6]) + (sum[3] + sum[7]));
  }
  double total = 0.0;
  for (const double part : parts_) total += part;
  return total;
}

template class FrictionMatrix<2>;
template class FrictionMatrix<3>;

}  // namespace shmoo::hydro
