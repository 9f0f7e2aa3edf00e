#include "hydro/spacings/spacings.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "scene/refinement.hpp"
#include "sph/cells.hpp"

namespace shmoo::hydro {
namespace {

constexpr double hesitation = 0.5;  // [coarse spacings] beyond a border before a particle is split or merged
constexpr double nearness = 1.2;    // [their own spacings] within which two merge
constexpr double finest_share = 0.25;

}  // namespace

template <int D>
Spacings<D>::Spacings(const scene::Scene& scene) : zone_(scene) {
  if (const char* misfit = scene::misfit_of_refinements(scene))
    throw base::InputError({{scene.domain.refinements.front().where, misfit}});
}

template <int D>
void Spacings<D>::prepare(State<D>& state) const {
  state.share = &state.particles.template require<double>("share", "1");
  state.smoothing = &state.particles.template require<double>("smoothing", "m");
  state.gradient = &state.particles.template require<base::Mat<D>>("gradient", "1/s");
  measure(state);
}

template <int D>
void Spacings<D>::measure(State<D>& state) const {
  for (std::size_t i = 0; i < state.particles.size(); ++i)
    (*state.smoothing)[i] = state.scales.smoothing * zone_.narrowing(state.particles.position[i]);
}

template <int D>
void Spacings<D>::exchange(State<D>& state, Places& places) {
  split(state, places);
  merge(state, places);
  measure(state);
}

// The first part stays where its whole was in the store.
template <int D>
void Spacings<D>::split(State<D>& state, Places& places) {
  const double deep = hesitation * state.scales.spacing;
  std::vector<std::uint32_t> copies;  // of those that are split
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    if (state.particles.role[i] != sph::Role::fluid || (*state.share)[i] <= finest_share) continue;
    if (!(zone_.depth(state.particles.position[i]) > deep)) continue;
    const auto parts = std::size_t(std::lround((*state.share)[i] / finest_share));
    if (copies.size() + parts - 1 <= places.free()) copies.insert(copies.end(), parts - 1, std::uint32_t(i));
  }
  const std::size_t before = state.particles.size();
  state.particles.append(copies);
  for (std::size_t k = 0; k < copies.size();) {
    std::size_t end = k;
    while (end < copies.size() && copies[end] == copies[k]) ++end;
    place_parts(state, places, copies[k], before + k, end - k + 1);
    k = end;
    ++splits_;
  }
}

// Four parts on the corners of a square, two along the flow; each moves as the fluid does where it is.
template <int D>
void Spacings<D>::place_parts(State<D>& state, Places& places, std::uint32_t i, std::size_t first,
                              std::size_t parts) const {
  const double side = 0.5 * state.scales.spacing;  // [m] of the square
  const double speed = state.velocity[i].norm();
  const Vec along = speed > 0.0 ? Vec(state.velocity[i] / speed) : Vec(Vec::Unit(0));
  const Vec x = state.particles.position[i], v = state.velocity[i];
  for (std::size_t k = 0; k < parts; ++k) {
    const std::size_t part = k == 0 ? i : first + k - 1;
    Vec way = (k == 0 ? 0.5 : -0.5) * side * along;
    for (int a = 0; a < D && parts > 2; ++a) way[a] = (k >> a & 1U) != 0 ? 0.5 * side : -0.5 * side;
    state.particles.position[part] = state.box.wrap(x + way);
    state.velocity[part] = v + state.gradient->values()[part] * way;
    (*state.share)[part] = finest_share;
    state.volume[part] = state.mass(part) / state.density[part];
    if (k == 0) continue;
    state.particles.id[part] = places.new_id();
    places.take(part);
  }
}

// Pairs of like mass, outside, that are near enough to each other, the nearest first.
template <int D>
std::vector<typename Spacings<D>::Pair> Spacings<D>::pairs(const State<D>& state) const {
  const double deep = -hesitation * state.scales.spacing;
  std::vector<std::uint32_t> light;
  std::vector<Vec> points;
  for (std::size_t i = 0; i < state.particles.size(); ++i) {
    if (state.particles.role[i] != sph::Role::fluid || (*state.share)[i] >= 1.0) continue;
    if (!(zone_.depth(state.particles.position[i]) < deep)) continue;
    light.push_back(std::uint32_t(i));
    points.push_back(state.particles.position[i]);
  }
  std::vector<Pair> found;
  if (light.empty()) return found;
  sph::Cells<D> cells;
  cells.build(points, state.box, nearness * state.scales.spacing);
  for (std::size_t k = 0; k < light.size(); ++k) {
    const std::uint32_t i = light[k], id = state.particles.id[i];
    const double within = nearness * state.spacing(i);
    std::array<std::size_t, 27> around;
    const std::size_t count = cells.around(cells.cell_of(points[k]), around);
    for (std::size_t c = 0; c < count; ++c) {
      for (const std::uint32_t other : cells.members(around[c])) {
        const std::uint32_t j = light[other], partner = state.particles.id[j];
        if (!(id < partner) || (*state.share)[i] != (*state.share)[j]) continue;
        const double distance2 = state.box.nearest(points[other] - points[k]).squaredNorm();
        if (distance2 < within * within) found.push_back({distance2, id, partner, i, j});
      }
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

template <int D>
void Spacings<D>::merge(State<D>& state, Places& places) {
  std::vector<bool> gone(state.particles.size(), false), busy(gone);
  bool any = false;
  for (const Pair& pair : pairs(state)) {
    if (busy[pair.i] || busy[pair.j]) continue;
    busy[pair.i] = busy[pair.j] = gone[pair.j] = any = true;
    join(state, pair.i, pair.j);
    places.leave(pair.j);
    ++merges_;
  }
  if (any) state.particles.remove([&](std::size_t i) { return gone[i]; });
}

// Particle i takes in j, which is as heavy.
template <int D>
void Spacings<D>::join(State<D>& state, std::uint32_t i, std::uint32_t j) const {
  Vec& x = state.particles.position[i];
  x = state.box.wrap(x + 0.5 * state.box.nearest(state.particles.position[j] - x));
  state.velocity[i] = 0.5 * (state.velocity[i] + state.velocity[j]);
  (*state.share)[i] += (*state.share)[j];
  state.volume[i] += state.volume[j];
  state.density[i] = state.mass(i) / state.volume[i];
}

template class Spacings<2>;
template class Spacings<3>;

}  // namespace shmoo::hydro
