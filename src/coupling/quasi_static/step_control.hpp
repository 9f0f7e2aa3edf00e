#pragma once
// How long the next macro step of a wall may be, so that all steps together cost its length no more than a tolerance.
// A step of first order is off by half the difference between what it did to the length and what the step before it
// foretold (Hairer, Norsett & Wanner 1993, "Solving Ordinary Differential Equations I", II.4); a hundredth of the
// tolerance falls to every step, or, where that is more, an equal share to every second. Steps are not repeated, so the
// first is short and the next are hardly longer.
#include "scene/scene.hpp"

namespace shmoo::coupling {

class StepControl {
 public:
  // Where realisations are random a step of this kind would follow their noise: all steps are equal, as are those that
  // the scene gives.
  StepControl(const scene::Scene& scene, bool random);

  double step() const { return step_; }  // [s]
  bool controlled() const { return controlled_; }
  // A step of dt [s] has lengthened the wall by `change` [m] to `length` [m].
  void learn(double dt, double change, double length);

  double error() const { return error_; }        // [m] that all steps so far may have cost
  double shortest() const { return shortest_; }  // [s] of those that the tolerance chose
  double longest() const { return longest_; }    // [s]
  int steps() const { return steps_; }

 private:
  double tolerance_, until_;  // [1], [s]
  bool controlled_;
  double step_;                    // [s]
  double rate_ = 0, error_ = 0;    // [m/s] of the last step, [m]
  double shortest_, longest_ = 0;  // [s]
  int steps_ = 0;
};

}  // namespace shmoo::coupling
