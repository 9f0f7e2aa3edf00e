#pragma once
// A closed wall around a cavity, symmetric about the x axis: layers of particles, counted from the inside, in columns,
// counted from the tip (+x) to the back (-x), of the half plane y > 0. The rest are mirror images. Either a body of
// revolution about the x axis (axial) or a cylinder in plane strain, of which all amounts are per unit depth and of the
// half y > 0.
#include <vector>

#include "hydro/solid/elastic_law.hpp"

namespace shmoo::hydro {

using Vec2 = base::Vec<2>;
using Mat2 = base::Mat<2>;

struct Shell {
  bool axial = true;
  int layers = 0, columns = 0;
  scene::ElasticLaw law = scene::ElasticLaw::neo_hookean;
  double bulk = 0;  // [Pa] K

  // By particle [column * layers + layer]. The reference is the state of the last re-reference.
  std::vector<Vec2> X, x;      // [m] reference and present position
  std::vector<Mat2> B;         // elastic gradient of the reference
  std::vector<double> b;       // elastic hoop stretch of the reference
  std::vector<double> V0;      // [m^3], plane: [m^2], without stress
  std::vector<double> shear;   // [Pa] G
  std::vector<Vec2> inside;    // [m] by column: from the innermost particle to the inner surface, in the reference
  std::vector<Vec2> outside;   // [m] by column: from the outermost particle to the outer surface
  std::vector<double> growth;  // [1/s] rate of the last step

  std::size_t size() const { return x.size(); }
  std::size_t at(int column, int layer) const { return std::size_t(column * layers + layer); }
};

struct Ring {
  double inner = 0, outer = 0;  // [m] radii
  int layers = 0, columns = 0;
};

// At rest without stress, centred at the origin.
Shell make_shell(const Ring& ring, bool axial, scene::ElasticLaw law, const Moduli& moduli);

}  // namespace shmoo::hydro
