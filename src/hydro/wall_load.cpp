// The load on a wall is the sum of the pair forces that its particles and the fluid exchange. What the pair friction
// passes on through a surface is the Laplace form's traction eta dv/dn, which is the true one where the surface rests;
// so friction is taken in the frame that turns with the wall. A pair's force acts halfway between the two, which is at
// the surface in the mean.
#include <Eigen/Geometry>

#include "hydro/fluid.hpp"
#include "hydro/pair_reach.hpp"

namespace shmoo::hydro {
namespace {

template <int D>
base::Vec<3> cross(const base::Vec<D>& r, const base::Vec<D>& f) {
  base::Vec<3> a = base::Vec<3>::Zero(), b = a;
  a.template head<D>() = r;
  b.template head<D>() = f;
  return a.cross(b);
}

template <int D>
class Loads {
 public:
  Loads(const State<D>& state, const WallMotion<D>& motion, const Slot<Viscosity<D>>& friction)
      : state_(state), motion_(motion) {
    if (const auto* present = std::get_if<Viscosity<D>>(&friction)) friction_ = *present;
  }

  // The force [N/m^(3-D)] of fluid particle f on the solid particle w.
  template <class Kernel>
  base::Vec<D> force(const Kernel& kernel, std::size_t w, std::size_t f, const base::Vec<D>& x) const {
    const double V_w = state_.volume[w], V_f = state_.volume[f], F = pair_F(state_, kernel, w, f, x.norm());
    base::Vec<D> force = F * (state_.pressure[w] * V_w * V_w + state_.pressure[f] * V_f * V_f) * x;
    if (state_.share) force = F * (state_.pressure[w] + state_.pressure[f]) * V_w * V_f * x;
    if (!state_.scaling) return force;
    const double common = V_w * V_f * F * 0.5 * ((*state_.scaling)[w] + (*state_.scaling)[f]);
    const base::Vec<D> v = state_.velocity[w] - state_.velocity[f] - motion_.turning(state_.particles.material[w], x);
    return force - common * (friction_.alpha * v + friction_.beta * (x.dot(v) / x.squaredNorm()) * x);
  }

 private:
  const State<D>& state_;
  const WallMotion<D>& motion_;
  Viscosity<D> friction_{};
};

}  // namespace

template <int D>
WallLoad<D> Fluid<D>::wall_load(std::uint16_t material, const Vec& about) const {
  WallLoad<D> load;
  const Loads<D> loads(state_, walls_.motion(), effects_.viscosity);
  const auto add = [&](const auto& kernel, std::size_t w) {
    const std::int32_t* row = state_.rows.partner() + state_.rows.first(w);
    const Vec from = state_.box.nearest(state_.particles.position[w] - about);
    for (std::uint32_t k = 0; k < state_.rows.count(w); ++k) {
      const auto f = std::size_t(row[k]);
      const Vec x = state_.separation(w, f), force = loads.force(kernel, w, f, x);
      load.force += force;
      load.torque += cross<D>(from - 0.5 * x, force);
    }
  };
  for (const std::uint32_t w : state_.rows.solid()) {
    if (state_.particles.material[w] == material) std::visit([&](const auto& kernel) { add(kernel, w); }, kernel_);
  }
  load.force *= state_.scales.depth;
  load.torque *= state_.scales.depth;
  return load;
}

template WallLoad<2> Fluid<2>::wall_load(std::uint16_t, const Vec&) const;
template WallLoad<3> Fluid<3>::wall_load(std::uint16_t, const Vec&) const;

}  // namespace shmoo::hydro
