#include "hydro/closed_room.hpp"

#include <algorithm>

namespace shmoo::hydro {
namespace {

// Of densities in a step, without solids: far more than a weakly compressible flow drifts, far less than shocks do, in
// which density that gathers keeps the fluid from being torn.
constexpr double most_change = 1e-5;

// Whether walls or sides let volume come or go.
bool opens(const scene::Scene& scene) {
  const bool pistons = std::any_of(scene.materials.begin(), scene.materials.end(), [](const auto& material) {
    return material.type == scene::MaterialType::wall && material.motion;
  });
  const auto open = [](const scene::Side& side) {
    return side.type == scene::SideType::inlet || side.type == scene::SideType::outlet;
  };
  return pistons || std::any_of(scene.domain.sides.begin(), scene.domain.sides.end(),
                                [&](const auto& axis) { return open(axis[0]) || open(axis[1]); });
}

}  // namespace

// Where part of the domain is empty, fluid may go there.
template <int D>
void ClosedRoom<D>::prepare(const State<D>& state, const scene::Scene& scene, bool summed, double solids) {
  if (summed || opens(scene)) return;
  const double cell = state.scales.mass / state.scales.density;
  double fluid = 0.0, inside = 0.0;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    const auto& x = state.particles.position[i];
    inside += ((x - state.box.lower).array() >= 0.0).all() && ((state.box.upper - x).array() >= 0.0).all();
    fluid += state.particles.role[i] == sph::Role::fluid;
  }
  if (inside * cell > state.box.volume() - 0.5 * cell) room_ = fluid * cell + solids;
}

template <int D>
void ClosedRoom<D>::close(State<D>& state, double solids) const {
  if (!(room_ > 0.0)) return;
  const auto& fluid = state.rows.fluid();
  double filled = 0.0;
  for (const std::uint32_t i : fluid) filled += state.volume[i];
  const double most = solids > 0.0 ? 1.0 : most_change;
  const double factor = 1.0 + std::clamp(filled / (room_ - solids) - 1.0, -most, most);
#pragma omp parallel for schedule(static) if (worth_threads(fluid.size() / 4))
  for (std::size_t n = 0; n < fluid.size(); ++n) {
    const std::size_t i = fluid[n];
    state.density[i] *= factor;
    state.volume[i] = state.scales.mass / state.density[i];
    state.pressure[i] = state.scales.pressure(state.density[i]);
  }
}

template class ClosedRoom<2>;
template class ClosedRoom<3>;

}  // namespace shmoo::hydro
