#include "hydro/shell/shell.hpp"

#include <cmath>
#include <numbers>

namespace shmoo::hydro {
namespace {

using std::numbers::pi;

// Of the half ring (plane) or the whole body of revolution (axial) between two radii and two angles from the x axis.
double sector(bool axial, double inner, double outer, double from, double to) {
  if (axial) return 2.0 * pi / 3.0 * (std::pow(outer, 3) - std::pow(inner, 3)) * (std::cos(from) - std::cos(to));
  return 0.5 * (outer * outer - inner * inner) * (to - from);
}

}  // namespace

Shell make_shell(const Ring& ring, bool axial, scene::ElasticLaw law, const Moduli& moduli) {
  Shell shell;
  shell.axial = axial;
  shell.layers = ring.layers;
  shell.columns = ring.columns;
  shell.law = law;
  shell.bulk = moduli.bulk;
  const double thick = (ring.outer - ring.inner) / ring.layers, angle = pi / ring.columns;
  for (int k = 0; k < ring.columns; ++k) {
    const Vec2 out(std::cos((k + 0.5) * angle), std::sin((k + 0.5) * angle));
    for (int l = 0; l < ring.layers; ++l) {
      const double below = ring.inner + l * thick;
      shell.X.push_back((below + 0.5 * thick) * out);
      shell.V0.push_back(sector(axial, below, below + thick, k * angle, (k + 1) * angle));
    }
    shell.inside.push_back(-0.5 * thick * out);
    shell.outside.push_back(0.5 * thick * out);
  }
  shell.x = shell.X;
  shell.B.assign(shell.size(), Mat2::Identity());
  shell.b.assign(shell.size(), 1.0);
  shell.shear.assign(shell.size(), moduli.shear);
  shell.growth.assign(shell.size(), 0.0);
  return shell;
}

}  // namespace shmoo::hydro
