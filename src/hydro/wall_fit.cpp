#include "hydro/wall_fit.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::hydro {
namespace {

constexpr double least_determinant = 0.02;  // of the fit's matrix over its diagonal, below which Q is left out
constexpr double most_growth = 2.0;         // |velocity behind the wall| over the largest in front, both relative

// Turns w by the smallest rotation that takes the unit vector a to b.
template <int D>
base::Vec<D> rotate(const base::Vec<D>& w, const base::Vec<D>& a, const base::Vec<D>& b) {
  const base::Vec<D> sum = a + b;
  return w - (sum.dot(w) / (1.0 + a.dot(b))) * sum + 2.0 * a.dot(w) * b;
}

}  // namespace

// Moments of the distances and of the relative velocities v, distances in reaches.
template <int D>
struct WallFit<D>::Sums {
  double d2 = 0, d3 = 0, d4 = 0, largest2 = 0;
  Vec dv = Vec::Zero(), d2v = Vec::Zero();

  void add(double W, double d, const Vec& v) {
    const double Wd = W * d;
    d2 += Wd * d;
    d3 += Wd * d * d;
    d4 += Wd * d * d * d;
    dv += Wd * v;
    d2v += Wd * d * v;
    largest2 = std::max(largest2, v.squaredNorm());
  }

  // The relative velocity at the distance -depth.
  Vec behind(double depth, const Vec& normal) const {
    const double determinant = d2 * d4 - d3 * d3;
    const Vec linear = dv / d2;
    Vec v = -depth * linear;
    if (determinant > least_determinant * d2 * d4) {
      const Vec G = (d4 * dv - d3 * d2v) / determinant, Q = (d2 * d2v - d3 * dv) / determinant;
      v = depth * (depth * Q - G);
    }
    v += (-depth * linear - v).dot(normal) * normal;
    const double size2 = v.squaredNorm(), most2 = most_growth * most_growth * largest2;
    if (size2 > most2) v *= std::sqrt(most2 / size2);
    return v;
  }
};

template <int D>
void WallFit<D>::prepare(State<D>& state, const sph::Surface<D>& surface, bool away_from_edges) {
  auto& particles = state.particles;
  normal_ = &particles.template require<Vec>("wall_normal", "1");
  depth_ = &particles.template require<double>("wall_depth", "m");
  curvature_ = &particles.template require<double>("wall_curvature", "1/m");
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool rigid = particles.role[i] == sph::Role::wall || particles.role[i] == sph::Role::still;
    if (!rigid) continue;
    const auto point = surface.nearest(particles.position[i], state.rows.cutoff());
    // Around a ball smaller than the reach the fit would see fluid on all sides of it.
    if (!point || std::abs(point->curvature) * state.scales.reach > 1.0) continue;
    if (away_from_edges && !surface.smooth_about(*point, state.scales.reach)) continue;
    (*normal_)[i] = point->normal;
    (*depth_)[i] = (point->place - particles.position[i]).dot(point->normal);
    (*curvature_)[i] = point->curvature;
  }
}

template <int D>
void WallFit<D>::follow(const State<D>& state) {
  if (followed_ == state.rows.builds()) return;
  followed_ = state.rows.builds();
  const auto& near = state.rows.near_wall();
  near_.clear();
  for (const std::uint32_t i : near) near_.push_back(state.particles.position[i]);
  sph::Cells<D> cells;
  cells.build(near_, state.box, state.rows.cutoff());
  const auto& solid = state.rows.solid();
  around_.resize(solid.size());
#pragma omp parallel for schedule(static) if (worth_threads(4 * solid.size()))
  for (std::size_t n = 0; n < solid.size(); ++n) list_around(state, cells, n);
}

template <int D>
void WallFit<D>::list_around(const State<D>& state, const sph::Cells<D>& cells, std::size_t n) {
  auto& list = around_[n];
  list.clear();
  const std::size_t i = state.rows.solid()[n];
  if (!fits(i)) return;
  const Vec place = state.box.wrap(foot(state, i));
  const double limit = state.rows.cutoff() * state.rows.cutoff();
  std::array<std::size_t, 27> around;
  const std::size_t count = cells.around(cells.cell_of(place), around);
  for (std::size_t c = 0; c < count; ++c) {
    for (const std::uint32_t k : cells.members(around[c])) {
      if (state.box.nearest(near_[k] - place).squaredNorm() < limit) list.push_back(state.rows.near_wall()[k]);
    }
  }
}

template <int D>
template <class Kernel>
bool WallFit<D>::velocity(const State<D>& state, const WallMotion<D>& motion, const Kernel& kernel, double t,
                          std::size_t n, Vec& result) const {
  const std::size_t i = state.rows.solid()[n];
  if (!fits(i)) return false;
  const auto material = state.particles.material[i];
  const double scale = 1.0 / state.scales.reach;
  const sph::SurfacePoint<D> point{foot(state, i), (*normal_)[i], (*curvature_)[i]};
  const bool turns = motion.slides(material);
  Sums sums;
  for (const std::uint32_t j : around_[n]) {
    const Vec from = state.box.nearest(state.particles.position[j] - point.place);
    const double W = kernel.W(from.norm()), d = point.distance(from);
    if (!(W > 0.0) || !(d > 0.0)) continue;
    Vec v = state.velocity[j];
    Vec normal = point.normal;
    if (point.curvature != 0.0) normal = point.normal_at(from);
    if (turns) v -= motion.surface_velocity(material, point.place + from - d * normal, t);
    if (point.curvature != 0.0) v = rotate<D>(v, normal, point.normal);
    sums.add(W, scale * d, v);
  }
  if (!(sums.d2 > 0.0)) return false;
  result = sums.behind(scale * (*depth_)[i], point.normal);
  if (turns) result += motion.surface_velocity(material, point.place, t);
  return true;
}

#define SHMOO_INSTANTIATE(D, Kernel)                                                                       \
  template bool WallFit<D>::velocity(const State<D>&, const WallMotion<D>&, const sph::Kernel<D>&, double, \
                                     std::size_t, Vec&) const;
#define SHMOO_INSTANTIATE_ALL(D)      \
  template class WallFit<D>;          \
  SHMOO_INSTANTIATE(D, Lucy)          \
  SHMOO_INSTANTIATE(D, CubicSpline)   \
  SHMOO_INSTANTIATE(D, QuinticSpline) \
  SHMOO_INSTANTIATE(D, WendlandC2)
SHMOO_INSTANTIATE_ALL(2)
SHMOO_INSTANTIATE_ALL(3)
#undef SHMOO_INSTANTIATE_ALL
#undef SHMOO_INSTANTIATE

}  // namespace shmoo::hydro
