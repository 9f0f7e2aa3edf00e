#pragma once
// Boussinesq buoyancy: species make the fluid lighter or heavier where only its weight matters, dv/dt = -b g with b =
// sum over species of expansion (C - reference), the relative loss of weight (D. J. Tritton, Physical Fluid Dynamics,
// 2nd ed., 1988, section 14.2). What every particle's b is must be told from outside.
#include "hydro/effects/body.hpp"

namespace shmoo::hydro {

template <int D>
class Buoyancy final : public BodyEffect<D> {
 public:
  // `largest` is the largest |b| to expect.
  Buoyancy(const base::Vec<D>& gravity, double largest) : gravity_(gravity), largest_(largest) {}

  static void choose(const scene::Scene& scene, const Scales<D>& scales, BodyEffects<D>& list) {
    if (scene.flow.buoyancy.empty()) return;
    list.push_back(std::make_unique<Buoyancy>(scales.gravity, scales.lightness));
  }

  const char* name() const override { return "buoyancy"; }

  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const override {
    const double f = largest_ * gravity_.norm();
    if (f > 0.0) list.push_back({name(), 0.25 * std::sqrt(scales.smoothing / f), "0.25 sqrt(hs/(b g))"});
  }

  // b by persistent id; 0 for those beyond the list's end.
  void set(std::vector<double> lightness) { lightness_ = std::move(lightness); }

  void apply(const BodyView<D>& view, std::span<const std::uint32_t> particles) const override {
    for (const std::uint32_t i : particles) {
      if (view.id[i] < lightness_.size()) view.acceleration[i] -= lightness_[view.id[i]] * gravity_;
    }
  }

 private:
  base::Vec<D> gravity_;  // [m/s^2]
  double largest_;
  std::vector<double> lightness_;
};

// The largest relative change of weight that the concentrations named in the scene make.
double largest_lightness(const scene::Scene& scene);

}  // namespace shmoo::hydro
