#pragma once
// What a shell's material feels round its cavity: round the axis of a body of revolution, along the wall in plane
// strain.
#include "hydro/shell/energy.hpp"

namespace shmoo::hydro {

struct Hoop {
  double strain = 0;  // [1] elastic
  double stress = 0;  // [Pa] Cauchy's
};

Hoop hoop_at(const Shell& shell, const ShellEnergy& energy, std::size_t i);

}  // namespace shmoo::hydro
