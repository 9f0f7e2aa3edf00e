#include "hydro/walls.hpp"

#include <cmath>

namespace shmoo::hydro {
namespace {

// Without viscosity no force looks at the velocity behind a wall.
bool wants_fit(scene::WallForm form, double viscosity) {
  if (form == scene::WallForm::automatic) return viscosity > 0.0;
  return form == scene::WallForm::second_order;
}

// Layers beyond two sides: the velocity normal to a side is that side's alone. Under a lid whose layers went on beyond
// its end, the end of the cavity would let the fluid through.
template <int D>
void hold_normals(const scene::Domain& domain, const base::Vec<D>& x, base::Vec<D>& v) {
  for (std::size_t a = 0; a < D; ++a) {
    const int side = x[int(a)] < domain.lower[a] ? 0 : x[int(a)] > domain.upper[a] ? 1 : -1;
    if (side < 0 || !scene::has_friction(domain.sides[a][std::size_t(side)].type)) continue;
    v[int(a)] = domain.sides[a][std::size_t(side)].velocity[a];
  }
}

}  // namespace

template <int D>
void Walls<D>::prepare(State<D>& state, const scene::Scene& scene) {
  auto& particles = state.particles;
  bool any = false;
  for (std::size_t i = 0; i < particles.size(); ++i) any = any || particles.role[i] != sph::Role::fluid;
  if (!any) return;
  state.wall_velocity = &particles.template require<base::Vec<D>>("wall_velocity", "m/s");
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.role[i] == sph::Role::fluid) continue;
    if (state.scaling) (*state.scaling)[i] = 1.0;
    Vec& v = (*state.wall_velocity)[i];
    v = motion_.surface_velocity(particles.material[i], particles.position[i], 0.0);
    if (particles.material[i] >= scene.materials.size()) hold_normals<D>(scene.domain, particles.position[i], v);
    state.velocity[i] = (*state.wall_velocity)[i];
  }
  const auto form = scene.numerics.walls;
  if (!wants_fit(form, state.scales.viscosity)) return;
  fit_.emplace().prepare(state, sph::Surface<D>(scene), form == scene::WallForm::automatic);
}

template <int D>
void Walls<D>::carry(State<D>& state, double t, double dt) {
  if (!motion_.any_moves()) return;
  auto& particles = state.particles;
#pragma omp parallel for schedule(static) if (worth_threads(particles.size() / 4))
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (particles.role[i] != sph::Role::wall || !motion_.moves(particles.material[i])) continue;
    const auto material = particles.material[i];
    particles.position[i] = motion_.carry(material, particles.position[i], t, dt);
    (*state.wall_velocity)[i] = motion_.surface_velocity(material, particles.position[i], t + dt);
    particles.position[i] = state.box.wrap(particles.position[i]);
    if (fit_) fit_->turn(motion_, material, i, motion_.moving(material, t, dt));
  }
}

template <int D>
template <class Kernel>
base::Vec<D> Walls<D>::mirrored(State<D>& state, const Kernel& kernel, double t, std::size_t i) const {
  const auto material = state.particles.material[i];
  const bool strains = motion_.strains(material);
  double sum = 0.0;
  Vec v = Vec::Zero();
  const std::uint64_t first = state.rows.first(i);
  for (std::uint64_t p = first; p < first + state.rows.count(i); ++p) {
    const auto j = std::size_t(state.rows.partner()[p]);
    const Vec x_ij = state.separation(i, j);
    const double W = kernel.W(x_ij.norm());
    state.rows.weight[p] = W;
    sum += W;
    v += W * state.velocity[j];
    if (strains) v -= W * motion_.surface_velocity(material, state.particles.position[i] - x_ij, t);
  }
  const Vec& wall = (*state.wall_velocity)[i];
  if (!(sum > 0.0)) return wall;
  return (strains ? 1.0 : 2.0) * wall - v / sum;
}

template <int D>
void Walls<D>::extrapolate_velocity(State<D>& state, const sph::AnyKernel<D>& any_kernel, double t) {
  const auto& solid = state.rows.solid();
  if (fit_) fit_->follow(state);
  std::visit(
      [&](const auto& kernel) {
#pragma omp parallel for schedule(static) if (worth_threads(4 * solid.size()))
        for (std::size_t n = 0; n < solid.size(); ++n) {
          const std::size_t i = solid[n];
          if (state.particles.role[i] == sph::Role::open) continue;
          Vec v = mirrored(state, kernel, t, i);
          if (fit_ && !motion_.strains(state.particles.material[i])) fit_->velocity(state, motion_, kernel, t, n, v);
          state.velocity[i] = v;
        }
      },
      any_kernel);
}

template <int D>
void Walls<D>::extrapolate_pressure(State<D>& state, double t) const {
  const auto& solid = state.rows.solid();
  const auto& scales = state.scales;
#pragma omp parallel for schedule(static) if (worth_threads(4 * solid.size()))
  for (std::size_t n = 0; n < solid.size(); ++n) {
    const std::size_t i = solid[n];
    if (state.particles.role[i] == sph::Role::open) continue;
    double sum = 0.0, p_sum = 0.0;
    base::Vec<D> lever = base::Vec<D>::Zero();
    const std::uint64_t first = state.rows.first(i);
    for (std::uint64_t p = first; p < first + state.rows.count(i); ++p) {
      const auto j = std::size_t(state.rows.partner()[p]);
      const double W = state.rows.weight[p];
      sum += W;
      p_sum += W * state.pressure[j];
      lever += W * state.density[j] * state.separation(i, j);
    }
    double pressure = scales.background;
    if (sum > 0.0) {
      const auto material = state.particles.material[i];
      const bool elastic = state.particles.role[i] == sph::Role::solid;
      const base::Vec<D> a =
          elastic ? (*state.wall_acceleration)[i] : motion_.acceleration(material, state.particles.position[i], t);
      const base::Vec<D> f = scales.body_force - a;
      pressure = (p_sum + f.dot(lever)) / sum;
    }
    state.pressure[i] = pressure;
    state.density[i] = scales.density_at(pressure);
    state.volume[i] = scales.mass / state.density[i];
  }
}

template class Walls<2>;
template class Walls<3>;

}  // namespace shmoo::hydro
