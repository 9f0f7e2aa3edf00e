#pragma once
// Open sides. Beyond each stand layers of particles that complete the support of the fluid and show it what is held
// there: at a side with a velocity this velocity, and the pressure continued from inside to first order; at a side
// with a pressure this pressure at the side, with the slope that it has inside, and the velocity from inside as it is
// at the side, dv/dn = 0. They move along the side's normal. Where velocities say how much fluid passes, sound would
// ring between hard inlets and soft outlets; so an outlet's pressure gives way to it: it is raised by rho c0 (u - u'),
// u the mean velocity at the side and u' what u relaxes to within half a crossing of sound, which reflects a third of
// the lowest mode and leaves a steady flow alone. One that moves into the domain becomes fluid, and the
// layers go on with a copy of it at their far end; fluid that moves out joins the layers, which end at their depth: so
// either side can let fluid in and out. (Layers that are fed from their far end: Federico et al. 2012, "Simulating 2D
// open-channel flows through an SPH model"; values from inside by corrected sums: Tafuni et al. 2018, "A versatile
// algorithm for the treatment of open boundary conditions in smoothed particle hydrodynamics GPU models".) An id is
// never given twice.
#include <vector>

#include "hydro/open/opening.hpp"
#include "hydro/places.hpp"
#include "hydro/state.hpp"
#include "sph/cells.hpp"
#include "sph/kernel.hpp"

namespace shmoo::hydro {

// What happened at an open side.
struct Passage {
  std::uint32_t place = 0, id = 0;  // in records; of the particle
  int side = 0;                     // 2 axis + (0 = min, 1 = max)
  bool enters = false;
};

template <int D>
class OpenSides {
 public:
  using Vec = base::Vec<D>;

  OpenSides(const scene::Scene& scene, const sph::Filling<D>& filling);

  // Moves what is beyond the sides.
  void carry(State<D>& state, double dt) const;
  // Lets particles in and out. The rows must be built anew after it.
  void exchange(State<D>& state, Places& places, double t);
  // Lists what is beyond the sides, and the fluid about it, once rows are built.
  void locate(const State<D>& state);
  // `dt` [s] since it was last called, up to time t.
  void set_velocity(State<D>& state, const sph::AnyKernel<D>& kernel, double t, double dt);
  void set_pressure(State<D>& state, const sph::AnyKernel<D>& kernel) const;

  // What passed since begin_interval(), in that order; nothing is kept before the first.
  const std::vector<Passage>& passages() const { return passages_; }
  void begin_interval() {
    keeps_passages_ = true;
    passages_.clear();
  }
  std::uint64_t entered() const { return entered_; }  // particles so far
  std::uint64_t left() const { return left_; }

 private:
  struct Beyond {
    std::uint32_t particle;
    std::uint32_t opening;
  };
  // Calls visit(weight, r, j) for the fluid j about the foot of the n-th particle beyond the sides, r away in reaches.
  template <class Visit>
  void visit_around(const State<D>& state, const sph::AnyKernel<D>& kernel, std::size_t n, const Visit& visit) const;
  double pressure_beyond(const State<D>& state, const sph::AnyKernel<D>& kernel, std::size_t n) const;
  void give_way(const State<D>& state, double dt);
  const Opening<D>& opening_beyond(const Vec& x) const;
  void let_in(State<D>& state, Places& places, std::size_t i, const Opening<D>& opening, double t);
  void let_out(State<D>& state, Places& places, std::size_t i, const Opening<D>& opening);
  void keep(const Passage& passage) {
    if (keeps_passages_) passages_.push_back(passage);
  }

  struct Flux {
    bool known = false;
    double slow = 0;    // [m/s] what the mean velocity relaxes to
    double excess = 0;  // [Pa] of the pressure over what is held
  };

  std::vector<Opening<D>> openings_;
  std::vector<Flux> flux_;  // of each
  double crossing_;         // [m] from one side to the other
  bool gives_way_ = false;
  std::vector<Beyond> beyond_;
  std::vector<std::vector<std::uint32_t>> around_;  // of each, fluid particles about its foot
  std::vector<Passage> passages_;
  bool keeps_passages_ = false;
  std::uint64_t entered_ = 0, left_ = 0;
};

extern template class OpenSides<2>;
extern template class OpenSides<3>;

}  // namespace shmoo::hydro
