#pragma once
// Ties integrated densities to where the particles are. The transport velocity moves particles and leaves their
// densities alone, and a stream that quickens along a wall within the kernel's width is seen half, as the wall shows
// density the friction's mirror: so what a kernel counts and what has been integrated drift apart. A round throat of
// four spacings behind a cone ran half empty, and twice too fast, at densities that were right to 3 %. What the two
// differ by more than `band` is taken back at the rate `rate` U/hs, where wholly is density re-initialised by summation
// (Zhang, Rezavand & Hu 2020, "Dual-criteria time stepping for weakly compressible smoothed particle hydrodynamics").
// Within the band densities are left alone: sums over particles off the lattice are 0.3 % off (root mean square; 1.6 %
// at most), and to follow them shakes the fluid: it took 15 % of the velocity on the axis of a pipe at Re = 500.
#include <cstdint>
#include <optional>

#include "hydro/state.hpp"
#include "hydro/wall_motion.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// Whether a kernel's sum over the fluid's neighbours is whole wherever fluid is: nothing empty within its reach.
template <int D>
bool is_covered(const scene::Scene& scene, const sph::Filling<D>& filling);

template <int D>
struct DensityTie {
  static constexpr const char* name = "density tied to places";
  static constexpr std::uint64_t every = 16;  // steps
  static constexpr double band = 0.01;        // of the density
  static constexpr double rate = 3.0;         // [U/hs]

  double share = 0;  // of what lies beyond the band, taken back in a second

  // Where the transport velocity acts between walls inside the domain or open sides, and neither walls nor elastic
  // solids move: those would take the sums along.
  static std::optional<DensityTie> choose(const scene::Scene& scene, const Scales<D>& scales);
  bool due(std::uint64_t step) const { return step > 0 && step % every == 0; }
  // After the density sweep of a step of dt [s]; reads its lists of neighbours.
  void apply(State<D>& state, const sph::AnyKernel<D>& kernel, double dt) const;
};

extern template bool is_covered(const scene::Scene&, const sph::Filling<2>&);
extern template bool is_covered(const scene::Scene&, const sph::Filling<3>&);
extern template struct DensityTie<2>;
extern template struct DensityTie<3>;

}  // namespace shmoo::hydro
