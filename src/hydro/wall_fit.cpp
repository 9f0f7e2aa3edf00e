#include "hydro/wall_fit.hpp"

#include <algorithm>
#include <cmath>

#include "hydro/eights.hpp"

namespace shmoo::hydro {
namespace {

constexpr double least_determinant = 0.02;  // of the fit's matrix over its diagonal, below which Q is left out
constexpr double most_viscous = 10.0;       // |v| reach/nu, relative to the wall, up to which fits are trusted in full
constexpr double most_growth = 2.0;         // |velocity behind the wall| over the largest in front, both relative

// Feet nearer to each other than this [spacings] are one.
constexpr double same_foot = 1e-6;

template <int D>
Lane dot(const Lane (&a)[D], const Lane (&b)[D]) {
  Lane sum = a[0] * b[0];
  for (int k = 1; k < D; ++k) sum = fma(a[k], b[k], sum);
  return sum;
}

// Turns w by the smallest rotation that takes the unit vector a to b.
template <int D>
void rotate(Lane (&w)[D], const Lane (&a)[D], const Lane (&b)[D]) {
  Lane both[D];
  for (int k = 0; k < D; ++k) both[k] = a[k] + b[k];
  const Lane along = dot<D>(both, w) / (1.0 + dot<D>(a, b)), turned = 2.0 * dot<D>(a, w);
  for (int k = 0; k < D; ++k) w[k] += turned * b[k] - along * both[k];
}

}  // namespace

// Moments of the distances and of the relative velocities v, distances in reaches.
template <int D>
struct WallFit<D>::Sums {
  double d2 = 0, d3 = 0, d4 = 0, largest2 = 0;
  Vec dv = Vec::Zero(), d2v = Vec::Zero(), wall = Vec::Zero();  // `wall` [m/s]: the surface's velocity

  static Sums of(const Lane (&distances)[3], const Lane (&dv)[D], const Lane (&d2v)[D], const Lane& largest2) {
    Sums sums{sum(distances[0]), sum(distances[1]), sum(distances[2])};
    sums.dv = sum<D>(dv);
    sums.d2v = sum<D>(d2v);
    for (int l = 0; l < lanes; ++l) sums.largest2 = std::max(sums.largest2, largest2[l]);
    return sums;
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
void WallFit<D>::prepare(State<D>& state, const sph::Surface<D>& surface, bool careful) {
  limited_ = careful;
  auto& particles = state.particles;
  normal_ = &particles.template require<Vec>("wall_normal", "1");
  depth_ = &particles.template require<double>("wall_depth", "m");
  curvature_ = &particles.template require<double>("wall_curvature", "1/m");
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const bool rigid = particles.role[i] == sph::Role::wall || particles.role[i] == sph::Role::still;
    if (!rigid) continue;
    const auto point = surface.nearest(particles.position[i], state.rows.cutoff());
    // Around a ball smaller than the reach the fit would see fluid on all sides of it.
    if (!point || std::abs(point->curvature) * state.reach(i) > 1.0) continue;
    if (careful && !surface.smooth_about(*point, state.reach(i))) continue;
    (*normal_)[i] = point->normal;
    (*depth_)[i] = (point->place - particles.position[i]).dot(point->normal);
    (*curvature_)[i] = point->curvature;
    if (point->axis != Vec::Zero()) {
      if (!axis_) axis_ = &particles.template require<Vec>("wall_axis", "1");
      (*axis_)[i] = point->axis;
    }
  }
}

template <int D>
void WallFit<D>::follow(const State<D>& state) {
  if (followed_ == state.rows.builds()) return;
  followed_ = state.rows.builds();
  list_feet(state);
  const auto& near = state.rows.near_wall();
  near_.clear();
  for (const std::uint32_t i : near) near_.push_back(state.particles.position[i]);
  sph::Cells<D> cells;
  cells.build(near_, state.box, state.rows.cutoff());
#pragma omp parallel for schedule(static) if (worth_threads(8 * feet_.size()))
  for (std::size_t f = 0; f < feet_.size(); ++f) list_around(state, cells, feet_[f]);
}

// Layers of one wall stand behind each other and share their feet.
template <int D>
void WallFit<D>::list_feet(const State<D>& state) {
  struct Key {
    std::size_t material;
    std::array<std::int64_t, D> place;
    std::uint32_t particle;
    auto operator<=>(const Key&) const = default;
  };
  std::vector<Key> keys;
  for (const std::uint32_t i : state.rows.solid()) {
    if (!fits(i)) continue;
    Key key{state.particles.material[i], {}, i};
    const Vec place = state.box.wrap(foot(state, i)) / (same_foot * state.scales.spacing);
    for (int a = 0; a < D; ++a) key.place[std::size_t(a)] = std::int64_t(std::floor(place[a] + 0.3));
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  feet_.clear();
  for (std::size_t k = 0; k < keys.size(); ++k) {
    const bool shared = k > 0 && keys[k].material == keys[k - 1].material && keys[k].place == keys[k - 1].place;
    if (!shared) feet_.emplace_back();
    feet_.back().solids.push_back(keys[k].particle);
  }
}

template <int D>
void WallFit<D>::list_around(const State<D>& state, const sph::Cells<D>& cells, Foot& foot_of) const {
  const Vec place = state.box.wrap(foot(state, foot_of.solids.front()));
  const double limit = state.rows.cutoff() * state.rows.cutoff();
  std::array<std::size_t, 27> around;
  const std::size_t count = cells.around(cells.cell_of(place), around);
  for (std::size_t c = 0; c < count; ++c) {
    for (const std::uint32_t k : cells.members(around[c])) {
      if (state.box.nearest(near_[k] - place).squaredNorm() < limit)
        foot_of.around.push_back(state.rows.near_wall()[k]);
    }
  }
}

template <int D>
template <class Kernel>
typename WallFit<D>::Sums WallFit<D>::moments(const State<D>& state, const WallMotion<D>& motion, const Kernel& kernel,
                                              double t, const Foot& foot_of, const sph::SurfacePoint<D>& point) const {
  const double reach = state.reach(foot_of.solids.front()), scale = 1.0 / reach, stretch = state.scales.reach / reach;
  const auto& position = state.particles.position.values();
  const SurfaceSpeeds<D> wall(motion, state.particles.material[foot_of.solids.front()], point.place, t);
  Lane normal[D], axis[D], distances[3]{}, dv[D]{}, d2v[D]{}, largest2{};
  for (int a = 0; a < D; ++a) normal[a] = same(point.normal[a]);
  for (int a = 0; a < D; ++a) axis[a] = same(point.axis[a]);
  by_eights(foot_of.around.data(), foot_of.around.size(), [&](const Eight& eight, std::size_t) {
    Lane from[D], v[D], out[D];  // from the foot; relative velocity; the surface's normal below the particle
    const Lane r2 = separations<D>(point.place, eight, position, state.rows.axes(), from);
    for (int a = 0; a < D; ++a) from[a] = -from[a];
    const Lane along = dot<D>(from, axis);
    Lane steep2{};
    for (int a = 0; a < D; ++a) {
      out[a] = normal[a] + point.curvature * (from[a] - along * axis[a]);
      steep2 = fma(out[a], out[a], steep2);
    }
    const Lane inverse = inverse_root(steep2), steep = steep2 * inverse;
    const Lane d = (2.0 * dot<D>(from, normal) + point.curvature * (r2 - along * along)) / (1.0 + steep);
    const Lane W = d > 0.0 ? Lane(eight.live * kernel.W(Lane(stretch * (r2 * inverse_root(r2))))) : Lane{};
    eight.of<D>(state.velocity.values(), v);
    for (int a = 0; a < D; ++a) {
      out[a] *= inverse;
      v[a] -= wall.at[a];
    }
    for (int a = 0; a < D; ++a)
      for (int b = 0; b < D; ++b) v[a] -= wall.slope(a, b) * (from[b] - d * out[b]);
    if (point.curvature != 0.0) rotate<D>(v, out, normal);
    const Lane e = scale * d, We = W * e, We2 = We * e, v2 = dot<D>(v, v);
    distances[0] += We2;
    distances[1] = fma(We2, e, distances[1]);
    distances[2] = fma(Lane(We2 * e), e, distances[2]);
    for (int a = 0; a < D; ++a) {
      dv[a] = fma(We, v[a], dv[a]);
      d2v[a] = fma(We2, v[a], d2v[a]);
    }
    largest2 = larger(largest2, W > 0.0 ? v2 : Lane{});
  });
  Sums sums = Sums::of(distances, dv, d2v, largest2);
  sums.wall = wall.at;
  return sums;
}

// A boundary layer thinner than the kernel is no parabola, and fits to it throw the fluid about (a cylinder at Re = 100
// with ten particles across loses its drag by them).
template <int D>
double WallFit<D>::trust(const State<D>& state, double reach, const Sums& sums) const {
  if (!limited_) return 1.0;
  const double cell = std::sqrt(sums.largest2) * reach / state.scales.kinematic_viscosity();
  return std::clamp(2.0 - cell / most_viscous, 0.0, 1.0);
}

template <int D>
void WallFit<D>::apply(State<D>& state, const WallMotion<D>& motion, const sph::AnyKernel<D>& any_kernel, double t) {
  follow(state);
  std::visit(
      [&](const auto& kernel) {
#pragma omp parallel for schedule(static) if (worth_threads(8 * feet_.size()))
        for (std::size_t f = 0; f < feet_.size(); ++f) {
          const std::uint32_t any = feet_[f].solids.front();
          const auto material = state.particles.material[any];
          if (motion.strains(material)) continue;
          const auto place = point(state, any);
          const Sums sums = moments(state, motion, kernel, t, feet_[f], place);
          if (!(sums.d2 > 0.0)) continue;
          const double reach = state.reach(any), scale = 1.0 / reach, share = trust(state, reach, sums);
          for (const std::uint32_t i : feet_[f].solids)
            state.velocity[i] +=
                share * (sums.behind(scale * (*depth_)[i], place.normal) + sums.wall - state.velocity[i]);
        }
      },
      any_kernel);
}

template class WallFit<2>;
template class WallFit<3>;

}  // namespace shmoo::hydro
