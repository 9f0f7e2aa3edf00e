#pragma once
// All that a step of the flow works on: the particle store with the columns that the chosen effects asked for, the rows
// and the scales. In the columns `velocity`, `density`, `pressure` and `volume` a solid particle carries what the walls
// extrapolated from the fluid; its true velocity is in `wall_velocity`.
#include <algorithm>
#include <cmath>

#include "hydro/pair_rows.hpp"
#include "hydro/scales.hpp"
#include "hydro/slots.hpp"
#include "sph/particles.hpp"

namespace shmoo::hydro {

template <int D>
struct State {
  using Vec = base::Vec<D>;
  using Mat = base::Mat<D>;

  State(sph::Filling<D>&& filling, const Scales<D>& its_scales)
      : particles(std::move(filling.particles)),
        box(filling.box),
        scales(its_scales),
        rows(box, scales.reach, skin(box, scales), scales.finest, filling.mirrors),
        velocity(particles.template require<Vec>("velocity", "m/s")),
        acceleration(particles.template require<Vec>("acceleration", "m/s^2")),
        density(particles.template require<double>("density", "kg/m^3")),
        pressure(particles.template require<double>("pressure", "Pa")),
        volume(particles.template require<double>("volume", "m^D")) {}

  sph::Particles<D> particles;
  base::Box<D> box;
  Scales<D> scales;
  PairRows<D> rows;
  Slots<D> slots;

  sph::Column<Vec>& velocity;
  sph::Column<Vec>& acceleration;  // of the next half kicks, all effects together
  sph::Column<double>& density;
  sph::Column<double>& pressure;
  sph::Column<double>& volume;  // m/rho

  // The skin [m] by which rows reach beyond the kernel; smaller where a periodic box leaves less room.
  static double skin(const base::Box<D>& box, const Scales<D>& scales) {
    double width = 0.3 * scales.finest;
    for (int a = 0; a < D; ++a) {
      if (box.periodic[a]) width = std::min(width, 0.5 * (box.upper[a] - box.lower[a]) - scales.reach);
    }
    return std::max(width, 0.0);
  }

  // Only where spacings differ.
  sph::Column<double>* share = nullptr;      // [1] m_i over the mass of the scales
  sph::Column<double>* smoothing = nullptr;  // [m] hs_i, half of its own reach; pairs meet within hs_i + hs_j
  sph::Column<Mat>* gradient = nullptr;      // [1/s] d v_a/d x_b, as the density sweep found it

  double share_of(std::size_t i) const { return share ? (*share)[i] : 1.0; }
  double mass(std::size_t i) const { return share_of(i) * scales.mass; }                           // [kg/m^(3-D)]
  double spacing(std::size_t i) const { return scales.spacing * std::pow(share_of(i), 1.0 / D); }  // [m]
  double reach(std::size_t i) const { return smoothing ? 2.0 * (*smoothing)[i] : scales.reach; }   // [m]

  // Only where something asked for them.
  sph::Column<double>* scaling = nullptr;         // s_i of the friction
  sph::Column<double>* narrowing = nullptr;       // [1/m^2] w_i of friction of fourth order
  sph::Column<Mat>* correction = nullptr;         // [1] B_i of the difference form
  sph::Column<Vec>* shift = nullptr;              // [m/s] dv, transport minus fluid velocity
  sph::Column<Vec>* noise = nullptr;              // [m/s^1.5] velocity impulse per root of time
  sph::Column<Vec>* driving = nullptr;            // [m/s^2] acceleration without friction, where that is implicit
  sph::Column<Vec>* start_velocity = nullptr;     // [m/s] at the beginning of the step, likewise
  sph::Column<Vec>* wall_velocity = nullptr;      // [m/s] of solids
  sph::Column<Vec>* wall_acceleration = nullptr;  // [m/s^2] of elastic solids
  sph::Column<Vec>* mean_shift = nullptr;         // [m] integral of dv over the interval
  sph::Column<Vec>* mean_velocity = nullptr;      // [m] integral of v over the interval

  Vec separation(std::size_t i, std::size_t j) const {
    Vec d = particles.position[i] - particles.position[j];
    for (int a = 0; a < D; ++a) d[a] = rows.axes()[std::size_t(a)].nearest(d[a]);
    return d;
  }
};

}  // namespace shmoo::hydro
