#include "hydro/walls.hpp"

#include "hydro/pair_reach.hpp"

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
  Lane weight{}, v[D]{}, way[D]{};
  const std::uint64_t first = state.rows.first(i);
  const auto material = state.particles.material[i];
  const bool strains = motion_.strains(material);
  by_eights(state.rows.partner() + first, state.rows.count(i), [&](const Eight& eight, std::size_t k) {
    Lane x[D], u[D];
    const Lane r2 =
        separations<D>(state.particles.position[i], eight, state.particles.position.values(), state.rows.axes(), x);
    const Lane W = eight.live * pair_W(state, kernel, i, eight, Lane(r2 * inverse_root(r2)));
    for (std::uint32_t l = 0; l < eight.size; ++l) state.rows.weight[first + k + l] = W[l];
    weight += W;
    eight.of<D>(state.velocity.values(), u);
    for (int a = 0; a < D; ++a) {
      v[a] = fma(W, u[a], v[a]);
      if (strains) way[a] = fma(W, x[a], way[a]);
    }
  });
  const Vec& wall = (*state.wall_velocity)[i];
  const double total = sum(weight);
  if (!(total > 0.0)) return wall;
  if (!strains) return 2.0 * wall - sum<D>(v) / total;
  const SurfaceSpeeds<D> strained(motion_, material, state.particles.position[i], t);
  return wall + strained.at - (sum<D>(v) + strained.slope * sum<D>(way)) / total;
}

template <int D>
void Walls<D>::extrapolate_velocity(State<D>& state, const sph::AnyKernel<D>& any_kernel, double t) {
  const auto& solid = state.rows.solid();
  std::visit(
      [&](const auto& kernel) {
#pragma omp parallel for schedule(static) if (worth_threads(4 * solid.size()))
        for (std::size_t n = 0; n < solid.size(); ++n) {
          const std::size_t i = solid[n];
          if (state.particles.role[i] != sph::Role::open) state.velocity[i] = mirrored(state, kernel, t, i);
        }
      },
      any_kernel);
  if (fit_) fit_->apply(state, motion_, any_kernel, t);
}

template <int D>
double Walls<D>::pressure_at(const State<D>& state, std::size_t i, const Vec& force) const {
  Lane weight{}, pressure{}, lever[D]{};
  const std::uint64_t first = state.rows.first(i);
  const bool pulled = force != Vec::Zero();
  by_eights(state.rows.partner() + first, state.rows.count(i), [&](const Eight& eight, std::size_t k) {
    Lane W{};
    for (std::uint32_t l = 0; l < eight.size; ++l) W[l] = state.rows.weight[first + k + l];
    weight += W;
    pressure = fma(W, eight.of(state.pressure.values()), pressure);
    if (!pulled) return;
    Lane x[D];
    separations<D>(state.particles.position[i], eight, state.particles.position.values(), state.rows.axes(), x);
    const Lane mass = W * eight.of(state.density.values());
    for (int a = 0; a < D; ++a) lever[a] = fma(mass, x[a], lever[a]);
  });
  const double total = sum(weight);
  if (!(total > 0.0)) return state.scales.background;
  return (sum(pressure) + (pulled ? force.dot(sum<D>(lever)) : 0.0)) / total;
}

template <int D>
void Walls<D>::extrapolate_pressure(State<D>& state, double t) const {
  const auto& solid = state.rows.solid();
  const auto& scales = state.scales;
#pragma omp parallel for schedule(static) if (worth_threads(4 * solid.size()))
  for (std::size_t n = 0; n < solid.size(); ++n) {
    const std::size_t i = solid[n];
    if (state.particles.role[i] == sph::Role::open) continue;
    const auto material = state.particles.material[i];
    const bool elastic = state.particles.role[i] == sph::Role::solid;
    const Vec a =
        elastic ? (*state.wall_acceleration)[i] : motion_.acceleration(material, state.particles.position[i], t);
    const double pressure = pressure_at(state, i, Vec(scales.body_force - a));
    state.pressure[i] = pressure;
    state.density[i] = scales.density_at(pressure);
    state.volume[i] = state.mass(i) / state.density[i];
  }
}

template class Walls<2>;
template class Walls<3>;

}  // namespace shmoo::hydro
