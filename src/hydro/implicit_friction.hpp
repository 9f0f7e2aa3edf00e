#pragma once
// The pair friction of viscosity, taken implicitly: the time step is then not bounded by 0.125 hs^2/nu. Without noise a
// step is the second-order L-stable SDIRK method (Alexander 1977, "Diagonally implicit Runge-Kutta methods for stiff
// O.D.E.'s") with all other forces as a source, so that a steady flow is the explicit one's. With noise it is the
// Crank-Nicolson step of the Ornstein-Uhlenbeck process, which keeps the Gaussian of temperature kT for any friction.
// The linear systems (1 + h G) v = b are solved without a matrix by BiCGSTAB (van der Vorst 1992): walls that show the
// fluid extrapolated velocities make G unsymmetric.
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "hydro/friction_matrix.hpp"

namespace shmoo::hydro {

template <int D>
class ImplicitFriction {
 public:
  static constexpr const char* name = "viscosity";

  // `renew_walls` writes the velocities of solids that follow from those of the fluid, both in state.velocity.
  using RenewWalls = std::function<void()>;

  explicit ImplicitFriction(const Viscosity<D>& viscosity) : matrix_(viscosity) {}

  static bool chosen(const scene::Scene& scene, const Scales<D>& scales);

  void describe(const Scales<D>& scales, double dt, std::vector<Derived>& list) const;

  // Takes the coefficients of all near pairs at the present positions; slots' volume and scaling are up to date.
  void prepare(const State<D>& state, const sph::AnyKernel<D>& kernel);
  // dv/dt = f - G v over dt from state.start_velocity, f the mean of state.driving and state.acceleration, which
  // replaces state.driving. The result replaces state.velocity, and dv/dt at the end state.acceleration.
  void advance(State<D>& state, const RenewWalls& renew_walls, double dt);
  // The same for dv = -G v dt + noise sqrt(dt); leaves the acceleration alone.
  void shake(State<D>& state, const RenewWalls& renew_walls, double dt);

  // Sum over all solutions so far of ln(residual at first/residual allowed), and how many there were.
  double decline() const { return decline_; }
  std::uint64_t solutions() const { return solutions_; }

 private:
  using Field = typename FrictionMatrix<D>::Field;

  void take(const State<D>& state, const std::vector<base::Vec<D>>& values, Field& field) const;
  void give(const Field& field, State<D>& state) const;
  // v = start + h (source_ - G v) from the guess in v_; the velocity and its rate go to the state.
  void stage(State<D>& state, const RenewWalls& renew_walls, double h, const std::vector<base::Vec<D>>& start);
  // Solves for `v_`, which holds a first guess.
  void solve(State<D>& state, const RenewWalls& renew_walls, double h);
  // result <- v + h G v; `linear`: of differences, for which walls rest where they would move on their own.
  void apply(State<D>& state, const RenewWalls& renew_walls, double h, Field& v, Field& result, bool linear);
  void fill_others(State<D>& state, const RenewWalls& renew_walls, Field& v, bool linear);
  double norm(const Field& v) { return std::sqrt(matrix_.product(v, v)); }
  double iterate(State<D>& state, const RenewWalls& renew_walls, double h, double aim);

  FrictionMatrix<D> matrix_;
  double decline_ = 0;
  std::uint64_t solutions_ = 0;
  Field v_, right_, r_, shadow_, p_, q_, s_, t_;
  std::vector<base::Vec<D>> source_, start_;  // by particle
  std::vector<base::Vec<D>> wall_at_rest_;    // [m/s] of solids about a fluid at rest
};

extern template class ImplicitFriction<2>;
extern template class ImplicitFriction<3>;

}  // namespace shmoo::hydro
