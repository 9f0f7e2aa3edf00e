// What sweeps read of a partner is put into slots before each sweep.
#include "hydro/fluid.hpp"

namespace shmoo::hydro {

template <int D>
void Fluid<D>::fill_slots() {
  auto& slots = state_.slots;
  const std::size_t size = state_.rows.blocks.slots();
  const bool diffuses = effects_.density_diffusion.index() > 0;
  for (auto& axis : slots.velocity) axis.resize(size);
  slots.volume.resize(size);
  if (diffuses) slots.density.resize(size);
  state_.rows.blocks.for_slots([&](std::size_t s, std::size_t i) {
    for (int a = 0; a < D; ++a) {
      const double v = state_.velocity[i][a];
      slots.velocity[std::size_t(a)][s] = state_.rows.blocks.mirrored(s, a) ? -v : v;
    }
    slots.volume[s] = state_.volume[i];
    if (diffuses) slots.density[s] = state_.density[i];
  });
}

template <int D>
void Fluid<D>::fill_stress() {
  auto& slots = state_.slots;
  const std::size_t size = state_.rows.blocks.slots();
  slots.stress.resize(size);
  if (state_.scaling) slots.scaling.resize(size);
  if (state_.noise) slots.id.resize(size);
  std::visit(
      [&](const auto& pressure) {
        state_.rows.blocks.for_slots([&](std::size_t s, std::size_t i) {
          slots.volume[s] = state_.volume[i];
          slots.stress[s] = pressure.stress(state_.pressure[i], state_.volume[i]);
          if (state_.scaling) slots.scaling[s] = (*state_.scaling)[i];
          if (state_.noise) slots.id[s] = state_.particles.id[i];
        });
      },
      effects_.pressure);
}

template void Fluid<2>::fill_slots();
template void Fluid<3>::fill_slots();
template void Fluid<2>::fill_stress();
template void Fluid<3>::fill_stress();

}  // namespace shmoo::hydro
