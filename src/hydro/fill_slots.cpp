// What sweeps read of a partner is put into slots before each sweep.
#include "hydro/fluid.hpp"

namespace shmoo::hydro {
namespace {

// What the density sweep sees of layers beyond a side. Friction mirrors the velocity along the side, but volume flows
// along it as if that went on: seen with the friction's mirror, a stream that the lid of a cavity drives into the
// corner would look as if half of it did not arrive, and go on into the wall. Walls inside the domain show the mirror.
template <int D>
base::Vec<D> without_friction(const State<D>& state, std::size_t i) {
  base::Vec<D> v = state.velocity[i];
  const auto& x = state.particles.position[i];
  const auto along = (x - state.box.lower).array() > 0.0 && (state.box.upper - x).array() > 0.0;
  if (along.all()) return v;
  for (int a = 0; a < D; ++a)
    if (along[a]) v[a] = 2.0 * (*state.wall_velocity)[i][a] - v[a];
  return v;
}

}  // namespace

template <int D>
template <class Velocity>
void Fluid<D>::fill_walls(Velocity&& velocity) {
  // Not with open sides: beyond these walls go on, and their layers would differ from those inside.
  if (state_.wall_velocity == nullptr || open_) return;
  const auto& blocks = state_.rows.blocks;
  blocks.for_others([&](std::size_t s, std::size_t i) {
    if (state_.particles.role[i] != sph::Role::wall) return;
    const Vec v = velocity(i);
    for (int a = 0; a < D; ++a) state_.slots.velocity[std::size_t(a)][s] = blocks.mirrored(s, a) ? -v[a] : v[a];
  });
}

template <int D>
void Fluid<D>::fill_slots() {
  auto& slots = state_.slots;
  const std::size_t size = state_.rows.blocks.slots();
  const bool diffuses = effects_.density_diffusion.index() > 0;
  for (auto& axis : slots.velocity) axis.resize(size);
  slots.volume.resize(size);
  if (diffuses) slots.density.resize(size);
  state_.rows.blocks.for_slots([&](std::size_t s, std::size_t i) {
    const Vec& v = state_.velocity[i];
    for (int a = 0; a < D; ++a) slots.velocity[std::size_t(a)][s] = state_.rows.blocks.mirrored(s, a) ? -v[a] : v[a];
    slots.volume[s] = state_.volume[i];
    if (diffuses) slots.density[s] = state_.density[i];
  });
  fill_walls([&](std::size_t i) { return without_friction(state_, i); });
}

template <int D>
void Fluid<D>::fill_stress() {
  auto& slots = state_.slots;
  const std::size_t size = state_.rows.blocks.slots();
  slots.stress.resize(size);
  if (state_.scaling) slots.scaling.resize(size);
  if (state_.narrowing) slots.narrowing.resize(size);
  if (state_.noise) slots.id.resize(size);
  std::visit(
      [&](const auto& pressure) {
        state_.rows.blocks.for_slots([&](std::size_t s, std::size_t i) {
          slots.volume[s] = state_.volume[i];
          slots.stress[s] = state_.share ? by_volume(pressure).stress(state_.pressure[i], state_.volume[i])
                                         : pressure.stress(state_.pressure[i], state_.volume[i]);
          if (state_.scaling) slots.scaling[s] = (*state_.scaling)[i];
          if (state_.narrowing) slots.narrowing[s] = (*state_.narrowing)[i];
          if (state_.noise) slots.id[s] = state_.particles.id[i];
        });
      },
      effects_.pressure);
  fill_walls([&](std::size_t i) { return state_.velocity[i]; });
}

template void Fluid<2>::fill_slots();
template void Fluid<3>::fill_slots();
template void Fluid<2>::fill_stress();
template void Fluid<3>::fill_stress();

}  // namespace shmoo::hydro
