#include "hydro/effects/closed_room.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/motion.hpp"

namespace shmoo::hydro {
namespace {

// Of densities in a step, without solids: far more than a weakly compressible flow drifts, far less than shocks do, in
// which density that gathers keeps the fluid from being torn.
constexpr double most_change = 1e-5;

bool keeps_volumes(const scene::RigidMotion& motion) {
  double stretching = 0.0, speed = 0.0, expansion = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    speed += std::abs(motion.velocity[a]);
    stretching += std::abs(motion.strain_rate[a]);
    expansion += motion.strain_rate[a];
  }
  return speed == 0.0 && std::abs(expansion) <= 1e-9 * stretching;
}

// Which cell of the starting lattice a place is in; cells that a periodic side makes one have one number.
template <int D>
std::array<long, D> cell_of(const sph::Filling<D>& filling, const base::Vec<D>& x) {
  std::array<long, D> cell;
  for (int a = 0; a < D; ++a) {
    const long cells = std::lround(filling.box.size()[a] / filling.spacing[a]);
    const long k = long(std::floor((x[a] - filling.box.lower[a]) / filling.spacing[a]));
    cell[std::size_t(a)] = filling.box.periodic[std::size_t(a)] ? (k % cells + cells) % cells : k;
  }
  return cell;
}

}  // namespace

template <int D>
bool is_enclosed(const sph::Filling<D>& filling) {
  if (filling.vacant.empty()) return true;
  std::set<std::array<long, D>> beside_empty;
  constexpr int around = D == 2 ? 9 : 27;
  for (const auto& x : filling.vacant) {
    for (int n = 0; n < around; ++n) {
      base::Vec<D> step;
      for (int a = 0, rest = n; a < D; ++a, rest /= 3) step[a] = rest % 3 - 1;
      beside_empty.insert(cell_of(filling, base::Vec<D>(x + step.cwiseProduct(filling.spacing))));
    }
  }
  const auto& particles = filling.particles;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (particles.role[i] == sph::Role::fluid && beside_empty.contains(cell_of(filling, particles.position[i])))
      return false;
  return true;
}

template <int D>
std::optional<ClosedRoom<D>> ClosedRoom<D>::choose(const scene::Scene& scene) {
  const auto opens = [](const scene::Material& material) {
    return material.type == scene::MaterialType::wall && material.motion && !keeps_volumes(*material.motion);
  };
  const bool drifts = scene.effects.transport_velocity || scene::has_solids(scene);
  if (!scene.effects.closed_room || !drifts || scene::has_open_sides(scene) ||
      std::any_of(scene.materials.begin(), scene.materials.end(), opens))
    return std::nullopt;
  return ClosedRoom{};
}

template <int D>
void ClosedRoom<D>::prepare(const State<D>& state, double solids) {
  double fluid = 0.0;  // coarse particles
  for (std::size_t i = 0; i < state.particles.size(); ++i)
    if (state.particles.role[i] == sph::Role::fluid) fluid += state.share_of(i);
  room = fluid * state.scales.mass / state.scales.density + solids;
}

template <int D>
void ClosedRoom<D>::apply(State<D>& state, double solids) const {
  const auto& fluid = state.rows.fluid();
  double filled = 0.0;
  for (const std::uint32_t i : fluid) filled += state.volume[i];
  const double most = solids > 0.0 ? 1.0 : double(every) * most_change;
  const double factor = 1.0 + std::clamp(filled / (room - solids) - 1.0, -most, most);
#pragma omp parallel for schedule(static) if (worth_threads(fluid.size() / 4))
  for (std::size_t n = 0; n < fluid.size(); ++n) {
    const std::size_t i = fluid[n];
    state.density[i] *= factor;
    state.volume[i] = state.mass(i) / state.density[i];
    state.pressure[i] = state.scales.pressure(state.density[i]);
  }
}

template bool is_enclosed(const sph::Filling<2>&);
template bool is_enclosed(const sph::Filling<3>&);
template struct ClosedRoom<2>;
template struct ClosedRoom<3>;

}  // namespace shmoo::hydro
