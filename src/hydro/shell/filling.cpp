#include "hydro/shell/filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shmoo::hydro {
namespace {

using Vec2 = base::Vec<2>;

constexpr int sweeps = 12;
constexpr double stiffness = 0.4;  // of the overlap of two particles that a sweep removes
constexpr double overlap = 1.5;    // [spacings] within which particles push each other
constexpr double clearance = 0.5;  // [spacings] from the wall

// The nearest point of the outline: on an edge next to its nearest corner, as edges are much of a length.
Vec2 nearest(const Points& outline, const Vec2& point) {
  std::size_t corner = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const double far = (outline[k] - point).squaredNorm();
    if (far < least) least = far, corner = k;
  }
  Vec2 best = outline[corner];
  for (std::size_t k = corner - std::min<std::size_t>(corner, 2); k < std::min(corner + 2, outline.size() - 1); ++k) {
    const Vec2 along = outline[k + 1] - outline[k];
    const double t = std::clamp((point - outline[k]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    const Vec2 candidate = outline[k] + t * along;
    if ((candidate - point).squaredNorm() < (best - point).squaredNorm()) best = candidate;
  }
  return best;
}

// Pushed away from the wall, if too close to it or outside. In a narrow place halfway to the axis.
Vec2 held_inside(const Points& outline, const Vec2& point, double distance) {
  const Vec2 wall = nearest(outline, point);
  const bool in = inside(outline, point);
  const double gap = (point - wall).norm();
  if (in && gap >= distance) return point;
  Vec2 inwards = in ? Vec2(point - wall) : Vec2(wall - point);
  inwards = gap > 0.0 ? Vec2(inwards / gap) : Vec2(0.0, -1.0);
  for (double far = distance; far > 1e-3 * distance; far *= 0.5) {
    Vec2 tried = wall + far * inwards;
    tried[1] = std::abs(tried[1]);
    if (inside(outline, tried)) return tried;
  }
  return in ? point : Vec2(wall[0], 0.5 * wall[1]);
}

// Adds what neighbours within a spacing push, mirror images included; found along x.
void push_apart(Points& particles, double spacing) {
  Points all = particles;
  for (const auto& x : particles)
    if (x[1] < spacing) all.emplace_back(x[0], -x[1]);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return all[a][0] < all[b][0]; });
  const double reach = overlap * spacing;
  Points push(all.size(), Vec2::Zero());
  for (std::size_t p = 0; p < order.size(); ++p) {
    for (std::size_t q = p + 1; q < order.size(); ++q) {
      const Vec2 apart = all[order[q]] - all[order[p]];
      if (apart[0] >= reach) break;
      const double r = apart.norm();
      if (r >= reach || r == 0.0) continue;
      const Vec2 half = 0.5 * stiffness * (reach - r) / r * apart;
      push[order[p]] -= half;
      push[order[q]] += half;
    }
  }
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles[i] += push[i];
    particles[i][1] = std::abs(particles[i][1]);
  }
}

}  // namespace

bool inside(const Points& outline, const Vec2& point) {
  if (!(point[1] > 0.0)) return false;
  bool in = false;
  const auto crosses = [&](const Vec2& a, const Vec2& b) {
    return (a[1] > point[1]) != (b[1] > point[1]) &&
           point[0] < a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1]);
  };
  for (std::size_t k = 0; k + 1 < outline.size(); ++k) in ^= crosses(outline[k], outline[k + 1]);
  in ^= crosses(outline.back(), {outline.back()[0], 0.0});
  in ^= crosses({outline.front()[0], 0.0}, outline.front());
  return in;
}

double area(const Points& outline) {
  double sum = 0.0;
  for (std::size_t k = 0; k + 1 < outline.size(); ++k)
    sum += 0.5 * (outline[k][0] - outline[k + 1][0]) * (outline[k][1] + outline[k + 1][1]);
  return sum;
}

void relax(Points& particles, const Points& outline) {
  if (particles.empty()) return;
  const double spacing = std::sqrt(area(outline) / double(particles.size()));
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    push_apart(particles, spacing);
    for (auto& x : particles) x = held_inside(outline, x, clearance * spacing);
  }
}

}  // namespace shmoo::hydro
