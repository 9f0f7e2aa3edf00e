#include "hydro/effects/shepard_filter.hpp"

namespace shmoo::hydro {
namespace {

template <int D, class Kernel>
void filter_block(State<D>& state, const Kernel& kernel, std::size_t b) {
  const auto& blocks = state.rows.blocks;
  const Block& block = blocks[b];
  const std::int32_t* partners = blocks.partners(block);
  Lane own[D], sum{}, volume{};
  for (int a = 0; a < D; ++a) own[a] = load(blocks.coordinate[std::size_t(a)].data() + lanes * b);
  for (std::uint32_t k = 0; k < block.partners; ++k) {
    const auto slot = std::size_t(partners[k]);
    Lane r2 = same(tiny);
    for (int a = 0; a < D; ++a) {
      const Lane d = own[a] - blocks.coordinate[std::size_t(a)][slot];
      r2 = fma(d, d, r2);
    }
    const Lane W = kernel.W(Lane(r2 * inverse_root(r2)));
    sum += W;
    volume = fma(same(state.slots.volume[slot]), W, volume);
  }
  for (std::uint32_t l = 0; l < block.size; ++l) {
    const std::size_t i = block.first + l;
    state.density[i] = state.scales.mass * sum[l] / volume[l];
    state.volume[i] = state.scales.mass / state.density[i];
  }
}

}  // namespace

template <int D>
void ShepardFilter<D>::apply(State<D>& state, const sph::AnyKernel<D>& any_kernel) const {
  const std::size_t size = state.rows.blocks.size();
  std::visit(
      [&](const auto& kernel) {
#pragma omp parallel for schedule(static) if (worth_threads(lanes * size))
        for (std::size_t b = 0; b < size; ++b) filter_block(state, kernel, b);
      },
      any_kernel);
}

template struct ShepardFilter<2>;
template struct ShepardFilter<3>;

}  // namespace shmoo::hydro
