#pragma once
// Particles that fill a shell's cavity evenly: they show where the cell's inside is and exert no force on the wall,
// whose load is the turgor. They spread as the cavity does, whose volume follows the wall (water passes).
#include <vector>

#include "base/vec.hpp"

namespace shmoo::hydro {

using Points = std::vector<base::Vec<2>>;

// Even-odd rule on the outline of the half plane y > 0, closed along the x axis.
bool inside(const Points& outline, const base::Vec<2>& point);

// Pushes neighbours apart and keeps all at least half a spacing, sqrt(area/count), inside; at the end none is outside.
void relax(Points& particles, const Points& outline);

// [m^2] of the half plane's part of the cavity.
double area(const Points& outline);

}  // namespace shmoo::hydro
