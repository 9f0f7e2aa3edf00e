#include "hydro/wall_motion.hpp"

#include <Eigen/Geometry>

#include "sph/particles.hpp"

namespace shmoo::hydro {

template <int D>
WallMotion<D>::WallMotion(const scene::Scene& scene) : entries_(scene.materials.size() + 2 * D) {
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const auto& material = scene.materials[m];
    if (material.motion) {
      entries_[m].moves = any_moves_ = true;
      entries_[m].motion = rigid(*material.motion);
    }
    if (material.surface_motion) entries_[m].surface = rigid(*material.surface_motion);
  }
  for (int a = 0; a < D; ++a) {
    for (int side = 0; side < 2; ++side) {
      auto& entry = entries_[sph::side_material(scene.materials.size(), a, side)];
      const auto& velocity = scene.domain.sides[std::size_t(a)][std::size_t(side)].velocity;
      for (int b = 0; b < D; ++b) entry.surface.velocity[b] = velocity[std::size_t(b)];
    }
  }
  for (auto& entry : entries_) entry.slides = entry.motion.any() || entry.surface.any();
}

template <int D>
typename WallMotion<D>::Rigid WallMotion<D>::rigid(const scene::RigidMotion& motion) {
  Rigid rigid;
  for (int a = 0; a < D; ++a) {
    rigid.velocity[a] = motion.velocity[std::size_t(a)];
    rigid.center[a] = motion.center[std::size_t(a)];
    rigid.strain[a] = motion.strain_rate[std::size_t(a)];
  }
  for (int a = 0; a < 3; ++a) rigid.spin[a] = motion.angular_velocity[std::size_t(a)];
  rigid.until = motion.until;
  return rigid;
}

template <int D>
base::Vec<D> WallMotion<D>::Rigid::spin_cross(const Vec& r) const {
  if constexpr (D == 2)
    return Vec(-spin[2] * r[1], spin[2] * r[0]);
  else
    return spin.cross(r);
}

template <int D>
base::Vec<D> WallMotion<D>::Rigid::at(const Vec& x, double t) const {
  if (t >= until) return Vec::Zero();
  const Vec r = x - center - t * velocity;
  return velocity + spin_cross(r) + strain.cwiseProduct(r);
}

template <int D>
base::Vec<D> WallMotion<D>::surface_velocity(std::size_t material, const Vec& x, double t) const {
  const Entry& entry = entries_[material];
  return entry.motion.at(x, t) + entry.surface.velocity + entry.surface.spin_cross(x - entry.surface.center);
}

template <int D>
base::Vec<D> WallMotion<D>::acceleration(std::size_t material, const Vec& x, double t) const {
  const Rigid& motion = entries_[material].motion;
  if (t >= motion.until) return Vec::Zero();
  const Vec r = x - motion.center - t * motion.velocity;
  return motion.spin_cross(motion.spin_cross(r)) + motion.strain.cwiseAbs2().cwiseProduct(r);
}

template <int D>
base::Vec<D> WallMotion<D>::Rigid::turned(const Vec& r, double dt) const {
  const double rate = spin.norm();
  if (rate == 0.0) return r;
  if constexpr (D == 2)
    return Eigen::Rotation2Dd(dt * spin[2]) * r;
  else
    return Eigen::AngleAxisd(dt * rate, spin / rate) * r;
}

template <int D>
base::Vec<D> WallMotion<D>::Rigid::carried(const Vec& r, double dt) const {
  if (strain == Vec::Zero()) return turned(r, dt);
  return (dt * strain).array().exp().matrix().cwiseProduct(r);
}

template <int D>
base::Vec<D> WallMotion<D>::turn(std::size_t material, const Vec& direction, double dt) const {
  const Rigid& motion = entries_[material].motion;
  if (!strains(material) || direction == Vec::Zero()) return motion.turned(direction, dt);
  return motion.carried(direction, -dt).normalized();
}

template <int D>
base::Vec<D> WallMotion<D>::carry(std::size_t material, const Vec& x, double t, double dt) const {
  const Rigid& motion = entries_[material].motion;
  const double lasts = moving(material, t, dt);
  const Vec from_center = x - motion.center - t * motion.velocity;
  if (lasts == 0.0) return x;
  return x + lasts * motion.velocity + (motion.carried(from_center, lasts) - from_center);
}

template class WallMotion<2>;
template class WallMotion<3>;

}  // namespace shmoo::hydro
