#pragma once
// A uniform body force, given as an acceleration.
#include <cmath>

#include "hydro/effects/body.hpp"

namespace shmoo::hydro {

template <int D>
class BodyForce final : public BodyEffect<D> {
 public:
  explicit BodyForce(const base::Vec<D>& acceleration) : acceleration_(acceleration) {}

  static void choose(const scene::Scene& scene, const Scales<D>& scales, BodyEffects<D>& list) {
    if (scene.flow.body_force) list.push_back(std::make_unique<BodyForce>(scales.body_force));
  }

  const char* name() const override { return "body force"; }

  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const override {
    const double f = acceleration_.norm();
    if (f > 0.0) list.push_back({name(), 0.25 * std::sqrt(scales.smoothing / f), "0.25 sqrt(hs/|f|)"});
  }

  void apply(const BodyView<D>& view, std::span<const std::uint32_t> particles) const override {
    for (const std::uint32_t i : particles) view.acceleration[i] += acceleration_;
  }

 private:
  base::Vec<D> acceleration_;  // [m/s^2]
};

}  // namespace shmoo::hydro
