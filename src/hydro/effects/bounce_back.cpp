#include "hydro/effects/bounce_back.hpp"

namespace shmoo::hydro {
namespace {

using base::Vec;

// What a fluid particle sees of the walls about it.
template <int D>
struct WallView {
  double inside = 0, all = 0;            // sums of V_j^2 W_ij over solids, over everything
  double steepness = 0;                  // sum of V_j^2 F_ij r_ij over solids: |grad| if all lay on one side
  Vec<D> outward = Vec<D>::Zero();       // -grad of `inside`
  Vec<D> velocity = Vec<D>::Zero();      // sum of V_j^2 W_ij v_j over solids
  Vec<D> from_nearest = Vec<D>::Zero();  // [m] from the nearest solid particle to this one
  double nearest2 = std::numeric_limits<double>::infinity();
};

// Where no solid stands nearer than this [spacings] a particle can neither touch a wall nor be inside one.
constexpr double clear = 1.5;

// Solids are the last in a row.
template <int D>
bool stands_clear(const State<D>& state, std::size_t i) {
  const double limit = clear * clear * state.scales.spacing * state.scales.spacing;
  const std::int32_t* row = state.rows.partner() + state.rows.first(i);
  for (std::uint32_t k = state.rows.count(i); k-- > 0 && std::size_t(row[k]) >= state.rows.blocks.fluid();) {
    if (state.particles.role[std::size_t(row[k])] == sph::Role::open) continue;
    if (state.separation(i, std::size_t(row[k])).squaredNorm() < limit) return false;
  }
  return true;
}

template <int D, class Kernel>
WallView<D> look(const State<D>& state, const Kernel& kernel, std::size_t i) {
  WallView<D> view;
  const auto& particles = state.particles;
  const double self = state.volume[i] * state.volume[i];
  view.all = self * kernel.W(0.0);
  const std::int32_t* row = state.rows.partner() + state.rows.first(i);
  for (std::uint32_t k = 0; k < state.rows.count(i); ++k) {
    const auto j = std::size_t(row[k]);
    const Vec<D> x = state.separation(i, j);
    const double r2 = x.squaredNorm(), r = std::sqrt(r2), V2 = state.volume[j] * state.volume[j];
    const double W = V2 * kernel.W(r);
    view.all += W;
    if (particles.role[j] == sph::Role::fluid || particles.role[j] == sph::Role::open) continue;
    const double F = V2 * kernel.F(r);
    view.inside += W;
    view.velocity += W * (*state.wall_velocity)[j];
    view.outward += F * x;
    view.steepness += F * r;
    if (r2 < view.nearest2) {
      view.nearest2 = r2;
      view.from_nearest = x;
    }
  }
  return view;
}

// True where the velocity was thrown back.
template <int D>
bool throw_back(const WallView<D>& view, double spacing, Vec<D>& v) {
  if (!(view.inside > 0.0)) return false;
  const Vec<D> wall = view.velocity / view.inside, relative = v - wall;
  const double size = view.outward.norm();
  const bool has_normal = size > 1e-6 * view.steepness;
  const Vec<D> n = has_normal ? Vec<D>(view.outward / size) : Vec<D>::Zero();
  const bool crossed = view.inside >= 0.5 * view.all;
  const bool touches = has_normal && view.from_nearest.dot(n) < 0.5 * spacing && relative.dot(n) < 0.0 &&
                       view.nearest2 < spacing * spacing;
  if (!crossed && !touches) return false;
  v = wall - relative + 2.0 * std::max(0.0, relative.dot(n)) * n;
  return true;
}

// The transport velocity must not carry a particle that all but touches a wall into it.
template <int D>
void hold_back(const WallView<D>& view, double spacing, Vec<D>& shift) {
  const double size = view.outward.norm();
  if (!(size > 1e-6 * view.steepness)) return;
  const Vec<D> n = view.outward / size;
  const bool near = view.from_nearest.dot(n) < 0.75 * spacing && view.nearest2 < spacing * spacing;
  if (near || view.inside >= 0.5 * view.all) shift -= std::min(0.0, shift.dot(n)) * n;
}

}  // namespace

template <int D>
std::uint64_t BounceBack<D>::apply(State<D>& state, const sph::AnyKernel<D>& kernel) const {
  const auto& near = state.rows.near_wall();
  std::uint64_t count = 0;
  std::visit(
      [&](const auto& k) {
#pragma omp parallel for schedule(static) reduction(+ : count) if (worth_threads(4 * near.size()))
        for (std::size_t n = 0; n < near.size(); ++n) {
          if (stands_clear(state, near[n])) continue;
          const auto view = look<D>(state, k, near[n]);
          count += throw_back<D>(view, state.scales.spacing, state.velocity[near[n]]);
          if (state.shift) hold_back<D>(view, state.scales.spacing, (*state.shift)[near[n]]);
        }
      },
      kernel);
  return count;
}

template struct BounceBack<2>;
template struct BounceBack<3>;

}  // namespace shmoo::hydro
