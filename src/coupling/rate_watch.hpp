#pragma once
// Methods that leap over events take rates that change in time at their mid-interval values. Intervals are therefore
// cut until the rates change little in them; a jump is closed in on until hardly an event can fall beside it.
#include <array>
#include <vector>

#include "rdme/expression.hpp"
#include "scene/scene.hpp"

namespace shmoo::rdme {
class Network;
}

namespace shmoo::coupling {

class RateWatch {
 public:
  // `volume` [m^3] of all voxels together; `places` [m], a few of which are looked at. Rates are judged at the
  // reference concentrations of the scene (splitting.hpp).
  RateWatch(const scene::Scene& scene, const rdme::Network& network, const std::vector<std::array<double, 3>>& places,
            double volume);

  // The latest time up to `end` [s] such that, from `t` on, each sampled rate's mid-interval value differs from its
  // mean by at most a thousandth, and from any value by at most a tenth, of the rate's largest value before `end`; or
  // such that fewer than a hundredth of an event is expected until then.
  double latest(double t, double end);

 private:
  struct Range {
    double largest = 0, mean_error = 0, change = 0;
  };
  Range look(rdme::Expression& rate, const std::array<double, 3>& place, double t, double end) const;
  double cut(rdme::Expression& rate, const std::array<double, 3>& place, double t, double end) const;

  std::vector<rdme::Expression> rates_;  // those that read the time, at reference concentrations
  std::vector<std::array<double, 3>> places_;
  double volume_;
};

}  // namespace shmoo::coupling
