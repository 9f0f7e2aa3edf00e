#include "sph/surface.hpp"

#include <algorithm>
#include <cmath>

#include "sph/fill.hpp"
#include "sph/surface_pieces.hpp"

namespace shmoo::sph {
namespace {

template <int D>
scene::Point point_of(const base::Vec<D>& x) {
  scene::Point point{};
  for (int a = 0; a < D; ++a) point[std::size_t(a)] = x[a];
  return point;
}

// The images of x through the periodic sides that lie no further than `within` beyond them, x first.
template <int D>
std::vector<base::Vec<D>> images_of(const base::Vec<D>& x, const base::Box<D>& box, double within) {
  std::vector<base::Vec<D>> images{x};
  for (int a = 0; a < D; ++a) {
    if (!box.periodic[std::size_t(a)]) continue;
    const double length = box.upper[a] - box.lower[a];
    const std::size_t before = images.size();
    for (std::size_t k = 0; k < before; ++k) {
      base::Vec<D> image = images[k];
      if (x[a] - box.lower[a] < within) {
        image[a] = x[a] + length;
        images.push_back(image);
      }
      if (box.upper[a] - x[a] < within) {
        image[a] = x[a] - length;
        images.push_back(image);
      }
    }
  }
  return images;
}

}  // namespace

template <int D>
double SurfacePoint<D>::harmonic(double distance) const {
  if (curvature == 0.0 || D == 1) return distance;
  const double part = curvature * distance;
  if (D == 2 || axis != Vec::Zero()) return std::log1p(part) / curvature;
  return distance / (1.0 + part);
}

template <int D>
Surface<D>::Surface(const scene::Scene& scene) : Surface(scene, {}) {
  for (const auto& material : scene.materials) flows_.push_back(material.type == scene::MaterialType::fluid);
}

template <int D>
Surface<D>::Surface(const scene::Scene& scene, std::vector<bool> materials)
    : scene_(scene),
      box_(domain_box<D>(scene.domain)),
      flows_(std::move(materials)),
      probe_(1e-6 * scene.domain.spacing) {
  list_sides();
}

template <int D>
void Surface<D>::list_sides() {
  for (int a = 0; a < D; ++a) {
    if (box_.periodic[std::size_t(a)]) continue;
    sides_.push_back({box_.lower, Vec::Unit(a), 0.0});
    sides_.push_back({box_.upper, -Vec::Unit(a), 0.0});
  }
}

template <int D>
int Surface<D>::material_at(const Vec& place) const {
  const Vec x = box_.wrap(place);
  for (int a = 0; a < D; ++a) {
    if (x[a] < box_.lower[a] || x[a] > box_.upper[a]) return -1;
  }
  const scene::Point point = point_of<D>(x);
  for (std::size_t r = scene_.regions.size(); r-- > 0;) {
    if (scene::contains(*scene_.regions[r].shape, point, D)) return scene_.regions[r].material;
  }
  return scene_.domain.material;
}

template <int D>
bool Surface<D>::fluid_at(const Vec& place) const {
  const int material = material_at(place);
  return material >= 0 && flows_[std::size_t(material)];
}

// Turns the normal towards the fluid; false where the point does not part x's solid from fluid, or x's fluid from
// solid.
template <int D>
bool Surface<D>::adjust(const Vec& x, bool from_fluid, SurfacePoint<D>& point) const {
  const bool ahead = fluid_at(point.place + probe_ * point.normal);
  const bool behind = fluid_at(point.place - probe_ * point.normal);
  if (ahead == behind) return false;
  if (behind) {
    point.normal = -point.normal;
    point.curvature = -point.curvature;
  }
  for (const double part : {0.25, 0.5, 0.75, 0.95}) {
    if (fluid_at(x + part * (point.place - x)) != from_fluid) return false;
  }
  return true;
}

template <int D>
std::optional<SurfacePoint<D>> Surface<D>::nearest(const Vec& x, double within, bool from_fluid) const {
  std::optional<SurfacePoint<D>> best;
  double least = within * within;
  for (const Vec& image : images_of<D>(x, box_, within)) {
    const auto offer = [&](const SurfacePoint<D>& found) {
      const double distance2 = (found.place - image).squaredNorm();
      if (!(distance2 < least)) return;
      SurfacePoint<D> point = found;
      if (!adjust(image, from_fluid, point)) return;
      least = distance2;
      point.place += x - image;
      best = point;
    };
    for (const auto& side : sides_) {
      offer({image - (image - side.place).dot(side.normal) * side.normal, side.normal, 0.0});
    }
    for (const auto& region : scene_.regions) each_foot<D>(*region.shape, image, offer);
  }
  return best;
}

template <int D>
bool Surface<D>::smooth_about(const SurfacePoint<D>& point, double within) const {
  const double tolerance = 0.1 * scene_.domain.spacing;
  for (int a = 0; a < D; ++a) {
    const Vec along = Vec::Unit(a) - point.normal[a] * point.normal;
    if (along.norm() < 0.5) continue;  // along the normal, nearly
    for (const double part : {-1.0, -0.5, 0.5, 1.0}) {
      Vec from = part * within * along.normalized();
      const Vec normal = point.normal_at(from);
      from -= point.distance(from) * normal;
      const Vec place = point.place + from;
      if (!fluid_at(place + tolerance * normal) || fluid_at(place - tolerance * normal)) return false;
    }
  }
  return true;
}

template struct SurfacePoint<1>;
template struct SurfacePoint<2>;
template struct SurfacePoint<3>;
template class Surface<1>;
template class Surface<2>;
template class Surface<3>;

}  // namespace shmoo::sph
