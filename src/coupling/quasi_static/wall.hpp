#pragma once
// The wall of one realisation as it softens and grows: from one equilibrium to the next.
#include <functional>
#include <span>

#include "coupling/quasi_static/wall_plan.hpp"
#include "hydro/shell/hoop.hpp"
#include "hydro/shell/rezone.hpp"

namespace shmoo::coupling {

class Wall {
 public:
  explicit Wall(const WallPlan& plan);

  // Softens and grows over dt [s] by what it holds [molecules/m^3] by species and particle, then finds its equilibrium.
  // Where it does not, the same again in shorter steps. Throws base::RunError where there is none.
  void advance(double t, double dt, const std::vector<std::vector<double>>& concentration);

  // Lays columns anew where they have been stretched since they were last; who takes how much of what is counted, or
  // nothing.
  std::vector<hydro::Take> rezone(double t);

  const hydro::Shell& shell() const { return shell_; }
  const hydro::Points& filling() const { return filling_; }
  std::vector<double> volumes() const;  // [m^3] by particle, real
  hydro::Points outer_surface() const { return equilibrium_.energy().outer_surface(shell_); }
  double length() const { return hydro::length_along_axis(outer_surface()); }  // [m] from tip to back
  hydro::Hoop hoop(std::size_t i) const { return hydro::hoop_at(shell_, equilibrium_.energy(), i); }
  double cavity_volume() const;                          // [m^3]
  double spacing() const;                                // [m] largest distance of neighbours along or across the wall
  double largest_residual() const { return residual_; }  // [p R^2], plane: [p R], since the start
  std::size_t outside() const { return outside_; }       // particles found outside the cavity since the start
  int iterations() const { return iterations_; }

 private:
  bool settle();
  void fill();
  [[noreturn]] void give_up(double t) const;
  void change(double dt, const std::vector<std::vector<double>>& concentration);

  const WallPlan& plan_;
  hydro::Shell shell_;
  mutable hydro::Equilibrium equilibrium_;
  hydro::Points filling_;
  double residual_ = 0;
  std::size_t outside_ = 0;
  int iterations_ = 0;
};

}  // namespace shmoo::coupling
