#pragma once
// The Shepard filter of zeroth order: every so many steps rho_i <- sum_j m_j W_ij/sum_j V_j W_ij, i included (Bonet &
// Lok 1999, "Variational and momentum preservation aspects of smooth particle hydrodynamic formulations"; Colagrossi &
// Landrini 2003): smooths what continuity leaves of acoustic noise, and leaves a uniform density alone.
#include <cstdint>
#include <optional>

#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

template <int D>
struct ShepardFilter {
  static constexpr const char* name = "Shepard filter";

  std::uint64_t every = 0;  // steps

  bool due(std::uint64_t step) const { return step > 0 && step % every == 0; }
  // Reads the slots' volume, writes density of fluid particles and the volume that belongs to it.
  void apply(State<D>& state, const sph::AnyKernel<D>& kernel) const;
};

extern template struct ShepardFilter<2>;
extern template struct ShepardFilter<3>;

}  // namespace shmoo::hydro
