#pragma once
// The energy of a fluid with elastic solids, which may only fall where nothing drives them. A solid that is too soft
// for the fluid's pressures takes more from it than it gives, step by step; this tells.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/experiment.hpp"
#include "scene/scene.hpp"

namespace shmoo::coupling {

// Whether solids swim in a fluid and nothing does work on either after the start.
bool undriven(const scene::Scene& scene);

class EnergyLaw {
 public:
  // `energy` [J] kinetic and elastic.
  void look(double energy) {
    largest_ = std::max(largest_, energy);
    rise_ = std::max(rise_, energy - least_);
    least_ = std::min(least_, energy);
  }
  double rise() const { return largest_ > 0.0 ? rise_ / largest_ : 0.0; }  // above what it was before, of the largest
  Experiment::Derived told() const;

 private:
  double largest_ = 0, rise_ = 0, least_ = std::numeric_limits<double>::infinity();  // [J]
};

}  // namespace shmoo::coupling
