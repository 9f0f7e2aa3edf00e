#pragma once
// The boundary-volume-fraction rule (sph-bvf Eqs. 42-48): where the walls' share phi_i of the kernel's support,
// particle i itself included, reaches one half, the particle has crossed a wall's surface and its velocity is thrown
// back relative to the wall: v_i <- 2 v_w - v_i + 2 max(0, (v_i - v_w).n) n, n = -grad phi/|grad phi| out of the wall.
// (Printed: v_i.n in place of the relative velocity, both signs of the condition, and a code without the self term that
// fires 0.21 spacings early.) A wall thinner than the support never fills half of it; so a particle that comes nearer
// than half a spacing, measured along n, to the layer of its nearest wall particle and still approaches is thrown back
// too. Elastic solids, which are known by their particles only, are guarded so; rigid walls have shapes (WallGuard).
#include <optional>

#include "hydro/state.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

template <int D>
struct BounceBack {
  static constexpr const char* name = "bounce back";

  static std::optional<BounceBack> choose(const scene::Scene& scene) {
    if (!scene.effects.bounce_back) return std::nullopt;
    return BounceBack{};
  }

  // Corrects velocities; returns how many particles were thrown back.
  std::uint64_t apply(State<D>& state, const sph::AnyKernel<D>& kernel) const;
};

extern template struct BounceBack<2>;
extern template struct BounceBack<3>;

}  // namespace shmoo::hydro
