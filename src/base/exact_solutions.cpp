#include "base/exact_solutions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace shmoo::base {
namespace {

using Point = ExactSolution::Point;
using Values = std::span<const double>;
using std::numbers::pi;
constexpr double negligible = 1e-18;  // relative, of the terms of a series

// C(0) = C0, C(L) = 0, nothing at t = 0. B. T. P. Jacob, dissertation, Eq. 2.30.
double slab_diffusion(const Point& x, double t, Values p) {
  const double length = p[0], kappa = p[1], s = x[0] / length;
  double c = 1.0 - s;
  for (int n = 1; n < 100000; ++n) {
    const double k = n * pi, decay = std::exp(-k * k * kappa * t / (length * length));
    c -= 2.0 / k * std::sin(k * s) * decay;
    if (decay < negligible) break;
  }
  return p[2] * c;
}

// C = C0 on the side y = L of a square, 0 on the others; steady. Eq. 2.33 of the same, in a form that does not
// overflow.
double plate_diffusion(const Point& x, double, Values p) {
  const double s = x[0] / p[0], r = x[1] / p[0];
  double c = 0.0;
  for (int n = 1; n < 20001; n += 2) {
    const double k = n * pi;
    const double ratio = std::exp(k * (r - 1.0)) * (1.0 - std::exp(-2.0 * k * r)) / (1.0 - std::exp(-2.0 * k));
    c += 4.0 / k * std::sin(k * s) * ratio;
    if (ratio < negligible) break;
  }
  return p[1] * c;
}

// Plane channel, from rest under a constant acceleration. J. P. Morris, P. J. Fox, Y. Zhu, J. Comput. Phys. 136 (1997)
// 214, Eq. 21.
double channel_flow(const Point& x, double t, Values p) {
  const double width = p[0], force = p[1], nu = p[2] / p[3], y = x[1];
  double u = force / (2.0 * nu) * y * (width - y);
  for (int n = 1; n < 20001; n += 2) {
    const double k = n * pi / width, decay = std::exp(-k * k * nu * t);
    u -= 4.0 * force / (nu * width * k * k * k) * std::sin(k * y) * decay;
    if (decay < negligible) break;
  }
  return u;
}

// The x component of the velocity between concentric cylinders of which the inner one turns, A r + B/r round the
// centre. G. K. Batchelor, An Introduction to Fluid Dynamics (Cambridge, 1967), section 4.5.
double circular_couette(const Point& x, double, Values p) {
  const double inner = p[0] * p[0], outer = p[1] * p[1], rate = p[2] / p[0];
  const double A = -rate * inner / (outer - inner), B = rate * inner * outer / (outer - inner);
  const double dx = x[0] - p[3], dy = x[1] - p[4];
  return -(A + B / (dx * dx + dy * dy)) * dy;
}

// The x component of plane Couette flow between walls that rise by `rise` over `run` and stand the `width` apart, the
// upper one sliding; the pattern repeats after the `period` across the walls.
double inclined_couette(const Point& x, double, Values p) {
  const double length = std::hypot(p[0], p[1]), across = (p[0] * x[1] - p[1] * x[0]) / length;
  return p[4] * p[0] / length * (across - p[3] * std::floor(across / p[3])) / p[2];
}

// u = -U cos kx sin ky, v = U sin kx cos ky with k = 2 pi/L decays as exp(-2 k^2 nu t). G. I. Taylor and A. E. Green,
// Proc. R. Soc. A 158 (1937) 499, in two dimensions.
double taylor_green_speed(const Point&, double t, Values p) {
  const double k = 2.0 * pi / p[1];
  return p[0] * std::exp(-2.0 * k * k * p[2] / p[3] * t);
}

// The integral of rho u^2/2 over the square L x L and its depth.
double taylor_green_energy(const Point& x, double t, Values p) {
  const double speed = taylor_green_speed(x, t, p.first(4));
  return 0.25 * p[3] * speed * speed * p[1] * p[1] * p[4];
}

// A thick ring in plane strain (n = 2) or sphere (n = 3) round the origin, under pressure from inside. S. P. Timoshenko
// and J. N. Goodier, "Theory of Elasticity" (McGraw-Hill, 1970), sections 28 and 136.
struct Lame {
  double nu, E, base, ratio;  // base: p a^n/(b^n - a^n), ratio: (b/r)^n

  Lame(const Point& x, Values p, int n) : nu(p[4]), E(2.0 * p[3] * (1.0 + nu)) {
    const double inner = std::pow(p[0], n), outer = std::pow(p[1], n);
    base = p[2] * inner / (outer - inner);
    ratio = outer / std::pow(std::hypot(x[0], x[1], x[2]), n);
  }
};

double lame_ring_strain(const Point& x, double, Values p) {
  const Lame l(x, p, 2);
  return (1.0 + l.nu) / l.E * l.base * (1.0 - 2.0 * l.nu + l.ratio);
}

double lame_ring_stress(const Point& x, double, Values p) {
  const Lame l(x, p, 2);
  return l.base * (1.0 + l.ratio);
}

double lame_sphere_strain(const Point& x, double, Values p) {
  const Lame l(x, p, 3);
  return l.base / l.E * (1.0 - 2.0 * l.nu + 0.5 * (1.0 + l.nu) * l.ratio);
}

double lame_sphere_stress(const Point& x, double, Values p) {
  const Lame l(x, p, 3);
  return l.base * (1.0 + 0.5 * l.ratio);
}

}  // namespace

const std::vector<ExactSolution>& exact_solutions() {
  using namespace dimensions;
  const std::vector<ExactSolution::Parameter> under_pressure{{"inner_radius", length},
                                                             {"outer_radius", length},
                                                             {"pressure", pressure},
                                                             {"shear_modulus", pressure},
                                                             {"poisson_ratio", none}};
  static const std::vector<ExactSolution> all{
      {"slab_diffusion",
       "C(x, t) in a slab from x = 0 (held at the concentration) to x = length (held at 0), empty at t = 0",
       concentration,
       {{"length", length}, {"diffusivity", diffusivity}, {"concentration", concentration}},
       slab_diffusion},
      {"plate_diffusion",
       "steady C(x, y) in the square from 0 to length whose side y = length is held at the concentration, the others "
       "at 0",
       concentration,
       {{"length", length}, {"concentration", concentration}},
       plate_diffusion},
      {"channel_flow",
       "u(y, t) between walls at y = 0 and y = width, from rest under a constant acceleration",
       speed,
       {{"width", length}, {"acceleration", acceleration}, {"viscosity", viscosity}, {"density", density}},
       channel_flow},
      {"circular_couette",
       "u_x(x, y) between concentric cylinders, the inner one turning, the outer one at rest",
       speed,
       {{"inner_radius", length}, {"outer_radius", length}, {"inner_speed", speed}, {"x", length}, {"y", length}},
       circular_couette},
      {"inclined_couette",
       "u_x(x, y) between inclined walls through the origin and a width above, the upper one sliding",
       speed,
       {{"run", length}, {"rise", length}, {"width", length}, {"period", length}, {"speed", speed}},
       inclined_couette},
      {"taylor_green_speed",
       "the largest speed of decaying Taylor-Green vortices in the periodic square",
       speed,
       {{"speed", speed}, {"length", length}, {"viscosity", viscosity}, {"density", density}},
       taylor_green_speed},
      {"taylor_green_energy",
       "their kinetic energy",
       energy,
       {{"speed", speed}, {"length", length}, {"viscosity", viscosity}, {"density", density}, {"depth", length}},
       taylor_green_energy},
      {"lame_ring_strain",
       "hoop strain u/r of a thick ring round the origin, in plane strain, under pressure from inside", none,
       under_pressure, lame_ring_strain},
      {"lame_ring_stress", "its hoop stress", pressure, under_pressure, lame_ring_stress},
      {"lame_sphere_strain", "hoop strain u/r of a thick sphere round the origin under pressure from inside", none,
       under_pressure, lame_sphere_strain},
      {"lame_sphere_stress", "its hoop stress", pressure, under_pressure, lame_sphere_stress}};
  return all;
}

const ExactSolution* find_exact_solution(std::string_view name) {
  const auto& all = exact_solutions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace shmoo::base
