#include "hydro/shell/outline.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace shmoo::hydro {
namespace {

using Vec2 = base::Vec<2>;

Vec2 image(const Vec2& point) { return {point[0], -point[1]}; }

// Of point k, which may lie beyond either end.
Vec2 point_at(const Points& outline, long k) {
  const long n = long(outline.size());
  return k < 0   ? image(outline[std::size_t(-1 - k)])
         : k < n ? outline[std::size_t(k)]
                 : image(outline[std::size_t(2 * n - 1 - k)]);
}

double end_of_axis(const Vec2& first, const Vec2& second) {
  const double a = first[1] * first[1], b = second[1] * second[1];
  return (first[0] * b - second[0] * a) / (b - a);
}

// Of the curve through points first .. last, at arc length `at` from the first.
double fitted_curvature(const Points& outline, long first, long last, double at) {
  const long count = last - first + 1;
  Eigen::MatrixX3d powers(count, 3);
  Eigen::MatrixX2d places(count, 2);
  double s = -at;
  for (long q = 0; q < count; ++q) {
    const Vec2 here = point_at(outline, first + q);
    if (q > 0) s += (here - point_at(outline, first + q - 1)).norm();
    powers.row(q) << 1.0, s, s * s;
    places.row(q) = here.transpose();
  }
  const double scale = std::max(std::abs(powers(0, 1)), std::abs(powers(count - 1, 1)));
  powers.col(1) /= scale;
  powers.col(2) /= scale * scale;
  const Eigen::Matrix<double, 3, 2> fit = powers.colPivHouseholderQr().solve(places);
  const Vec2 d = fit.row(1).transpose() / scale, dd = 2.0 * fit.row(2).transpose() / (scale * scale);
  return (d[0] * dd[1] - d[1] * dd[0]) / std::pow(d.norm(), 3);
}

// The first point backwards or forwards from k beyond the window, or two steps away.
long reach(const Points& outline, long k, int direction, double window, double& travelled) {
  long q = k;
  travelled = 0.0;
  for (int steps = 0; steps < long(outline.size()); ++steps) {
    const double step = (point_at(outline, q + direction) - point_at(outline, q)).norm();
    if (steps >= 2 && travelled + step > window) break;
    travelled += step;
    q += direction;
  }
  return q;
}

}  // namespace

double length_along_axis(const Points& outline) {
  const std::size_t n = outline.size();
  return end_of_axis(outline[0], outline[1]) - end_of_axis(outline[n - 1], outline[n - 2]);
}

std::vector<double> arc_length(const Points& outline) {
  std::vector<double> arc{outline.front()[1]};
  for (std::size_t k = 1; k < outline.size(); ++k) arc.push_back(arc.back() + (outline[k] - outline[k - 1]).norm());
  return arc;
}

double curvature(const Points& outline, std::size_t k, double window) {
  double back = 0.0, forth = 0.0;
  const long first = reach(outline, long(k), -1, window, back), last = reach(outline, long(k), 1, window, forth);
  return fitted_curvature(outline, first, last, back);
}

double tip_curvature(const Points& outline, double window) {
  double forth = 0.0;
  const long last = reach(outline, 0, 1, window - outline.front()[1], forth);
  return fitted_curvature(outline, -1 - last, last, forth + outline.front()[1]);
}

double least_curvature(const Points& outline, double window) {
  const double middle = 0.5 * (outline.front()[0] + outline.back()[0]);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < outline.size(); ++k)
    if (outline[k][0] > middle) least = std::min(least, curvature(outline, k, window));
  return least;
}

}  // namespace shmoo::hydro
