#include "hydro/wall_guard.hpp"

#include <algorithm>
#include <cmath>

#include "sph/surface_pieces.hpp"

namespace shmoo::hydro {
namespace {

constexpr double look = 0.05;      // [spacings] between the places at which a way is looked at
constexpr double clear = 1.75;     // [spacings] further from all solid particles nothing touches a wall
constexpr double touching = 1e-3;  // [spacings]
constexpr int halvings = 30, rounds = 3, most_looks = 1000;

template <int D>
scene::Point point_of(const base::Vec<D>& x) {
  scene::Point point{};
  for (int a = 0; a < D; ++a) point[std::size_t(a)] = x[a];
  return point;
}

}  // namespace

template <int D>
WallGuard<D>::WallGuard(const scene::Scene& scene)
    : box_(sph::domain_box<D>(scene.domain)),
      spacing_(scene.domain.spacing),
      domain_material_(scene.domain.material),
      regions_(scene.regions) {
  bool any_rests = false;
  for (const auto& material : scene.materials) {
    const bool wall = material.type == scene::MaterialType::wall || material.type == scene::MaterialType::still;
    is_wall_.push_back(wall);
    moves_.push_back(wall && material.motion);
    any_rests = any_rests || (wall && !material.motion);
  }
  for (int a = 0; a < D; ++a) {
    for (const int side : {0, 1}) {
      const auto type = scene.domain.sides[std::size_t(a)][std::size_t(side)].type;
      const bool open =
          type == scene::SideType::periodic || type == scene::SideType::inlet || type == scene::SideType::outlet;
      closed_[std::size_t(a)][std::size_t(side)] = !open;
      slips_[std::size_t(2 * a + side)] = type == scene::SideType::slip;
      any_rests = any_rests || !open;
    }
  }
  if (any_rests) frames_.push_back(resting);
  for (std::size_t m = 0; m < moves_.size(); ++m)
    if (moves_[m]) frames_.push_back(int(m));
}

// Beyond an open side what is at the side goes on.
template <int D>
int WallGuard<D>::material_at(const Vec& x) const {
  auto point = point_of<D>(x);
  for (int a = 0; a < D; ++a) {
    if (box_.periodic[std::size_t(a)]) continue;
    const double inside = touching * spacing_;  // the upper faces of shapes do not belong to them
    if (!closed_[std::size_t(a)][0]) point[std::size_t(a)] = std::max(point[std::size_t(a)], box_.lower[a]);
    if (!closed_[std::size_t(a)][1]) point[std::size_t(a)] = std::min(point[std::size_t(a)], box_.upper[a] - inside);
  }
  for (std::size_t r = regions_.size(); r-- > 0;)
    if (scene::contains(*regions_[r].shape, point, D)) return regions_[r].material;
  return domain_material_;
}

template <int D>
int WallGuard<D>::side_beyond(const Vec& x) const {
  for (int a = D; a-- > 0;) {
    if (x[a] < box_.lower[a] && closed_[std::size_t(a)][0]) return 2 * a;
    if (x[a] > box_.upper[a] && closed_[std::size_t(a)][1]) return 2 * a + 1;
  }
  return -1;
}

template <int D>
int WallGuard<D>::wall_at(const Vec& place, int frame) const {
  const Vec x = box_.wrap(place);
  if (frame == resting) {
    if (const int side = side_beyond(x); side >= 0) return sph::side_material(is_wall_.size(), side / 2, side % 2);
  }
  const int material = material_at(x);
  if (frame != resting) return material == frame ? material : nothing;
  return material >= 0 && is_wall_[std::size_t(material)] && !moves_[std::size_t(material)] ? material : nothing;
}

template <int D>
typename WallGuard<D>::Way WallGuard<D>::seen_from(int frame, const WallMotion<D>& motion, const Vec& x,
                                                   const Vec& path, double t, double dt) const {
  if (frame == resting) return {x - path, x};
  const auto material = std::size_t(frame);
  const Vec before = motion.center(material, t - dt), now = motion.center(material, t);
  const Vec start = box_.nearest(x - path - before), end = start + path - (now - before);
  return {motion.home(material, start, t - dt), motion.home(material, end, t)};
}

// The first place on the way that lies in a wall.
template <int D>
typename WallGuard<D>::Hit WallGuard<D>::find(const Way& way, int frame) const {
  const Vec path = way.to - way.from;
  Hit hit;
  const double length = path.norm() / (look * spacing_);
  if (!(length < most_looks)) return hit;  // blown up: Fluid tells
  const int looks = std::max(1, int(std::ceil(length)));
  double outside = 0.0, inside = 0.0;
  for (int k = 1; k <= looks && hit.material == nothing; ++k) {
    outside = inside;
    inside = double(k) / looks;
    hit.material = wall_at(way.from + inside * path, frame);
  }
  if (hit.material == nothing) return hit;
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (outside + inside);
    (wall_at(way.from + middle * path, frame) == nothing ? outside : inside) = middle;
  }
  hit.place = way.from + outside * path;
  const Vec normal = nearest_normal(hit.place, touching * spacing_).second;
  hit.normal = normal.dot(path) > 0.0 ? Vec(-normal) : normal;
  const Vec rest = way.to - hit.place;  // goes back as far as it would have gone on
  hit.end = hit.place - std::min(1.0, outside / std::max(1.0 - outside, 1e-300)) * rest;
  return hit;
}

// What starts in a wall, as disordered particles may, stays where it is unless it comes out.
template <int D>
typename WallGuard<D>::Hit WallGuard<D>::hold(const Way& way, int frame) const {
  const auto [foot, normal] = nearest_normal(way.from, spacing_);
  Hit hit;
  if (normal == Vec::Zero()) return hit;
  hit.normal = (foot - way.from).normalized();
  if ((way.to - way.from).dot(hit.normal) >= 0.0) return hit;
  hit.material = wall_at(way.from, frame);
  hit.end = way.from;
  return hit;
}

// The nearest piece of a surface within a distance: its point and its normal, which is 0 where there is none.
template <int D>
std::pair<base::Vec<D>, base::Vec<D>> WallGuard<D>::nearest_normal(const Vec& place, double within) const {
  const Vec x = box_.wrap(place);
  std::pair<Vec, Vec> best{Vec::Zero(), Vec::Zero()};
  const auto offer = [&](const sph::SurfacePoint<D>& point) {
    const double distance = (point.place - x).norm();
    if (!(distance < within)) return;
    within = distance;
    best = {place + (point.place - x), point.normal};
  };
  for (const auto& region : regions_) sph::each_foot<D>(*region.shape, x, offer);
  for (int a = 0; a < D; ++a) {
    for (const int side : {0, 1}) {
      if (!closed_[std::size_t(a)][std::size_t(side)]) continue;
      Vec foot = x;
      foot[a] = side == 0 ? box_.lower[a] : box_.upper[a];
      offer({foot, Vec::Unit(a), 0.0});
    }
  }
  return best;
}

template <int D>
typename WallGuard<D>::Hit WallGuard<D>::meet(const Way& way, int frame) const {
  return wall_at(way.from, frame) == nothing ? find(way, frame) : hold(way, frame);
}

template <int D>
void WallGuard<D>::turn_back(State<D>& state, const WallMotion<D>& motion, std::size_t i, const Hit& hit, int frame,
                             double t) const {
  Vec& x = state.particles.position[i];
  const auto material = std::size_t(hit.material);
  x = box_.wrap(frame == resting ? hit.end : motion.carry(material, hit.end, 0.0, t));
  const Vec n = frame == resting ? hit.normal : motion.turn(material, hit.normal, motion.moving(material, 0.0, t));
  const Vec wall = motion.surface_velocity(material, x, t), relative = state.velocity[i] - wall;
  const bool slips = material >= is_wall_.size() && slips_[material - is_wall_.size()];
  if (slips)
    state.velocity[i] -= 2.0 * std::min(0.0, relative.dot(n)) * n;
  else if (n == Vec::Zero() || relative.dot(n) < 0.0)
    state.velocity[i] = wall - relative;
}

// Whether the particle has been turned back.
template <int D>
bool WallGuard<D>::guard(State<D>& state, const WallMotion<D>& motion, std::size_t i, double t, double dt) const {
  Vec& x = state.particles.position[i];
  const Vec shift = state.shift ? (*state.shift)[i] : Vec::Zero();
  const Vec start = x - dt * (state.velocity[i] + shift);
  bool shifted = shift != Vec::Zero(), turned = false, again = true;
  for (int round = 0; again && round < rounds; ++round) {
    again = false;
    for (const int frame : frames_) {
      const Hit hit = meet(seen_from(frame, motion, x, box_.nearest(x - start), t, dt), frame);
      if (hit.material == nothing) continue;
      again = true;
      if (shifted) {
        shifted = false;
        round = -1;
        x = box_.wrap(start + dt * state.velocity[i]);
        if (state.mean_shift) (*state.mean_shift)[i] -= dt * shift;
        break;
      }
      turn_back(state, motion, i, hit, frame, t);
      turned = true;
    }
  }
  return turned;
}

template <int D>
bool WallGuard<D>::touches(const State<D>& state, std::size_t i) const {
  const double limit = clear * clear * spacing_ * spacing_;
  const std::int32_t* row = state.rows.partner() + state.rows.first(i);
  for (std::uint32_t k = state.rows.count(i); k-- > 0 && std::size_t(row[k]) >= state.rows.blocks.fluid();) {
    if (state.separation(i, std::size_t(row[k])).squaredNorm() < limit) return true;
  }
  return false;
}

template <int D>
std::uint64_t WallGuard<D>::apply(State<D>& state, const WallMotion<D>& motion, double t, double dt) const {
  if (frames_.empty()) return 0;
  const auto& near = state.rows.near_wall();
  std::uint64_t count = 0;
#pragma omp parallel for schedule(static) reduction(+ : count) if (worth_threads(4 * near.size()))
  for (std::size_t n = 0; n < near.size(); ++n) {
    const std::size_t i = near[n];
    if (!touches(state, i)) continue;
    count += guard(state, motion, i, t, dt);
  }
  return count;
}

template class WallGuard<2>;
template class WallGuard<3>;

}  // namespace shmoo::hydro
