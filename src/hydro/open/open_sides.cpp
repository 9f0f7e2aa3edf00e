#include "hydro/open/open_sides.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "hydro/open/side_fit.hpp"

namespace shmoo::hydro {
namespace {

// [spacings] that a particle is let beyond a side before it counts as out, so that none goes in and out by turns.
constexpr double hesitation = 0.5;
// [crossings of sound] in which the velocity that an outlet gives way to sound from follows the mean one.
constexpr double relaxation = 0.5;

}  // namespace

template <int D>
OpenSides<D>::OpenSides(const scene::Scene& scene, const sph::Filling<D>& filling)
    : openings_(openings_of<D>(scene, filling)) {
  flux_.resize(openings_.size());
  crossing_ = filling.box.size()[openings_.front().axis];
  for (const auto& opening : openings_) gives_way_ = gives_way_ || opening.velocity;
}

template <int D>
const Opening<D>& OpenSides<D>::opening_beyond(const Vec& x) const {
  const Opening<D>* best = &openings_.front();
  for (const auto& opening : openings_)
    if (opening.beyond(x) > best->beyond(x)) best = &opening;
  return *best;
}

template <int D>
void OpenSides<D>::carry(State<D>& state, double dt) const {
  for (const auto& [i, o] : beyond_) {
    const int axis = openings_[o].axis;
    state.particles.position[i][axis] += dt * state.velocity[i][axis];
  }
}

template <int D>
void OpenSides<D>::exchange(State<D>& state, Places& places, double t) {
  auto& particles = state.particles;
  const double hesitant = hesitation * state.scales.spacing;
  std::vector<std::uint32_t> in;
  std::vector<bool> gone(particles.size(), false);
  bool any_gone = false;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool flows = particles.role[i] == sph::Role::fluid;
    if (!flows && particles.role[i] != sph::Role::open) continue;
    const auto& opening = opening_beyond(particles.position[i]);
    const double beyond = opening.beyond(particles.position[i]);
    if (flows && beyond > hesitant) let_out(state, places, i, opening);
    if (!flows && beyond <= 0.0) in.push_back(std::uint32_t(i));
    gone[i] = !flows && beyond > opening.depth + hesitant;  // so a row keeps its number when it turns round
    any_gone = any_gone || gone[i];
  }
  const std::size_t before = particles.size();
  particles.append(in);
  gone.resize(particles.size(), false);
  for (std::size_t k = 0; k < in.size(); ++k) {
    const auto& opening = opening_beyond(particles.position[in[k]]);
    particles.position[before + k][opening.axis] += opening.outward() * opening.depth;
    particles.id[before + k] = places.new_id();
    let_in(state, places, in[k], opening, t);
  }
  if (any_gone) particles.remove([&](std::size_t i) { return gone[i]; });
}

template <int D>
void OpenSides<D>::let_in(State<D>& state, Places& places, std::size_t i, const Opening<D>& opening, double t) {
  if (places.free() == 0) {
    throw base::RunError(
        fmt::format("at t = {:g} s more particles are in the domain than it has places for, {}: fluid enters faster "
                    "than it leaves. "
                    "Let it out: give an outlet, or inlets whose velocities let in as much as they let out.",
                    t, places.all()));
  }
  state.particles.role[i] = sph::Role::fluid;
  keep({places.take(i), state.particles.id[i], 2 * opening.axis + opening.side, true});
  ++entered_;
}

template <int D>
void OpenSides<D>::let_out(State<D>& state, Places& places, std::size_t i, const Opening<D>& opening) {
  state.particles.role[i] = sph::Role::open;
  keep({places.leave(i), state.particles.id[i], 2 * opening.axis + opening.side, false});
  if (state.scaling) (*state.scaling)[i] = 1.0;
  if (state.shift) (*state.shift)[i] = Vec::Zero();
  state.acceleration[i] = Vec::Zero();
  ++left_;
}

template <int D>
void OpenSides<D>::locate(const State<D>& state) {
  const auto& x = state.particles.position;
  const double cutoff = state.rows.cutoff();
  std::vector<Vec> near;  // [m] where fluid near the sides is
  std::vector<std::uint32_t> index;
  beyond_.clear();
  for (std::size_t i = 0; i < x.values().size(); ++i) {
    const auto role = state.particles.role[i];
    if (role != sph::Role::fluid && role != sph::Role::open) continue;
    const auto& opening = opening_beyond(x[i]);
    if (role == sph::Role::open) beyond_.push_back({std::uint32_t(i), std::uint32_t(&opening - openings_.data())});
    if (role == sph::Role::open || opening.beyond(x[i]) < -cutoff) continue;
    near.push_back(x[i]);
    index.push_back(std::uint32_t(i));
  }
  sph::Cells<D> cells;
  cells.build(near, state.box, cutoff);
  around_.resize(beyond_.size());
#pragma omp parallel for schedule(static) if (worth_threads(4 * beyond_.size()))
  for (std::size_t n = 0; n < beyond_.size(); ++n) {
    const Vec foot = openings_[beyond_[n].opening].foot(x[beyond_[n].particle]);
    around_[n].clear();
    std::array<std::size_t, 27> cell;
    const std::size_t count = cells.around(cells.cell_of(foot), cell);
    for (std::size_t c = 0; c < count; ++c)
      for (const std::uint32_t k : cells.members(cell[c]))
        if (state.box.nearest(near[k] - foot).squaredNorm() < cutoff * cutoff) around_[n].push_back(index[k]);
  }
}

template <int D>
template <class Visit>
void OpenSides<D>::visit_around(const State<D>& state, const sph::AnyKernel<D>& any_kernel, std::size_t n,
                                const Visit& visit) const {
  const double scale = 1.0 / state.scales.reach;
  const Vec foot = openings_[beyond_[n].opening].foot(state.particles.position[beyond_[n].particle]);
  std::visit(
      [&](const auto& kernel) {
        for (const std::uint32_t j : around_[n]) {
          const Vec r = state.box.nearest(state.particles.position[j] - foot);
          visit(kernel.W(r.norm()), Vec(scale * r), std::size_t(j));
        }
      },
      any_kernel);
}

template <int D>
void OpenSides<D>::set_velocity(State<D>& state, const sph::AnyKernel<D>& kernel, double t, double dt) {
  for (const auto& [i, o] : beyond_) {
    const auto& opening = openings_[o];
    if (opening.velocity) state.velocity[i] = (*opening.velocity)(opening.foot(state.particles.position[i]), t);
  }
#pragma omp parallel for schedule(static) if (worth_threads(4 * beyond_.size()))
  for (std::size_t n = 0; n < beyond_.size(); ++n) {
    const auto& opening = openings_[beyond_[n].opening];
    if (opening.velocity) continue;
    SideFit<D, D, false> fit(opening.axis);
    visit_around(state, kernel, n, [&](double W, const Vec& r, std::size_t j) { fit.add(W, r, state.velocity[j]); });
    if (!fit.empty()) state.velocity[beyond_[n].particle] = fit.at(0.0);
  }
  if (gives_way_) give_way(state, dt);
}

template <int D>
void OpenSides<D>::give_way(const State<D>& state, double dt) {
  const auto& scales = state.scales;
  const double share = -std::expm1(-dt * scales.sound_speed / (relaxation * crossing_));
  for (std::size_t o = 0; o < openings_.size(); ++o) {
    if (openings_[o].velocity) continue;
    double sum = 0.0, count = 0.0;
    for (const auto& [i, opening] : beyond_) {
      if (opening != o) continue;
      sum += openings_[o].outward() * state.velocity[i][openings_[o].axis];
      count += 1.0;
    }
    if (!(count > 0.0)) continue;
    Flux& flux = flux_[o];
    if (!std::exchange(flux.known, true)) flux.slow = sum / count;
    flux.slow += share * (sum / count - flux.slow);
    flux.excess = scales.density * scales.sound_speed * (sum / count - flux.slow);
  }
}

template <int D>
double OpenSides<D>::pressure_beyond(const State<D>& state, const sph::AnyKernel<D>& kernel, std::size_t n) const {
  const auto& opening = openings_[beyond_[n].opening];
  const double distance =
      (state.particles.position[beyond_[n].particle][opening.axis] - opening.plane) / state.scales.reach;
  if (opening.velocity) {
    SideFit<D, 1, true> fit(opening.axis);
    visit_around(state, kernel, n, [&](double W, const Vec& r, std::size_t j) {
      fit.add(W, r, Eigen::Matrix<double, 1, 1>(state.pressure[j]));
    });
    return fit.empty() ? state.scales.background : fit.at(distance)[0];
  }
  const double held = state.scales.background + opening.pressure + flux_[beyond_[n].opening].excess;
  SlopeFit fit;
  visit_around(state, kernel, n,
               [&](double W, const Vec& r, std::size_t j) { fit.add(W, r[opening.axis], state.pressure[j] - held); });
  return held + fit.at(distance);
}

template <int D>
void OpenSides<D>::set_pressure(State<D>& state, const sph::AnyKernel<D>& kernel) const {
  const auto& scales = state.scales;
  const double c2 = scales.sound_speed * scales.sound_speed;
#pragma omp parallel for schedule(static) if (worth_threads(4 * beyond_.size()))
  for (std::size_t n = 0; n < beyond_.size(); ++n) {
    const std::size_t i = beyond_[n].particle;
    state.pressure[i] = pressure_beyond(state, kernel, n);
    state.density[i] = scales.density + (state.pressure[i] - scales.background) / c2;
    state.volume[i] = state.mass(i) / state.density[i];
  }
}

template class OpenSides<2>;
template class OpenSides<3>;

}  // namespace shmoo::hydro
