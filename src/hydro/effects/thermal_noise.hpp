#pragma once
// Thermal noise that balances the pair friction -[a v_ij + b e (e.v_ij)] (fluctuation and dissipation; Espanol &
// Revenga 2003). Their force is [A Wbar + (B/D) tr(dW) 1].e with Wbar the traceless symmetric part of a D x D matrix of
// N(0, dt) and A^2 = 4 kT a, B^2 = 2 kT [D b + (2 - D) a]. For a pair only the vector (matrix).e acts; it is Gaussian
// with the covariance
//   A^2 [1/2 + (1/2 - 1/D) ee] + (B^2/D) ee = 2 kT [a 1 + b ee]   per time,
// so it is drawn as such: D numbers xi in place of D^2, force = sqrt(2 kT) [sqrt(a) xi + (sqrt(a + b) - sqrt(a)) e
// (e.xi)]. The same xi acts on both partners with opposite sign.
#include <cmath>

#include "base/random_lanes.hpp"
#include "hydro/effects/absent.hpp"
#include "hydro/effects/pair.hpp"
#include "hydro/scales.hpp"

namespace shmoo::hydro {

template <int D>
struct ThermalNoise {
  static constexpr const char* name = "thermal noise";
  // Friction rate times step below which kT stays within 1 %.
  static constexpr double most_friction = 0.25;

  static constexpr double root_twelve = 3.4641016151377544;

  double across = 0,
         along = 0;  // [(N/m^(3-D)) sqrt(m^2 s)] sqrt(2 kT alpha), sqrt(2 kT (alpha + beta)) - sqrt(2 kT alpha)
  base::RandomKey key;

  using Ids = base::LaneRandom::Words;

  static Slot<ThermalNoise> choose(const scene::Scene& scene, const Scales<D>& scales, const base::RandomKey& key) {
    if (!scene.effects.thermal_noise) return Absent{};
    const double alpha = friction_alpha<D>(scales.viscosity, scales.bulk_viscosity);
    const double beta = friction_beta<D>(scales.viscosity, scales.bulk_viscosity);
    const double across = std::sqrt(2.0 * scales.thermal_energy * alpha);
    return ThermalNoise{across, std::sqrt(2.0 * scales.thermal_energy * (alpha + beta)) - across, key};
  }

  void limits(const Scales<D>& scales, std::vector<StepLimit>& list) const {
    if (!(scales.thermal_energy > 0.0)) return;
    list.push_back({name, explicit_limit(scales), "0.25/gamma, gamma the pair friction rate: kT within 1 %"});
  }

  // [s] with explicit friction
  static double explicit_limit(const Scales<D>& scales) { return most_friction / scales.friction; }

  // What the pairs of one evaluation share.
  base::LaneRandom at(std::uint64_t step) const { return {key, base::Stream::thermal_noise, step}; }

  // Adds the impulse per root of time [N/m^(3-D) sqrt(s)] of eight pairs; none where both ids are the same.
  void add(const ForcePair<D>& pair, const base::LaneRandom& random, const Ids& id_i, std::uint32_t id_j,
           Lane (&impulse)[D]) const {
    const Ids other = Ids{} + id_j;
    const auto first = id_i < other;
    base::LaneRandom::Words words[4];
    random.draw(first ? id_i : other, first ? other : id_i, words);
    Lane xi[D], projected{};
    for (int a = 0; a < D; ++a) {
      xi[a] = root_twelve * ((__builtin_convertvector(words[a], Lane) + 0.5) * 0x1p-32 - 0.5);
      projected = fma(xi[a], pair.x[a], projected);
    }
    const Lane strength = pair.V_i * pair.V_j * pair.F * pair.s, one = same(1.0);
    const Lane size = strength * inverse_root(strength + tiny) * (first ? one : id_i > other ? -one : Lane{});
    const Lane radial = along * (projected * pair.inverse_r * pair.inverse_r);
    for (int a = 0; a < D; ++a) impulse[a] += size * (across * xi[a] + radial * pair.x[a]);
  }
};

}  // namespace shmoo::hydro
