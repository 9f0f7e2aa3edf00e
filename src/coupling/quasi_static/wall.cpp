#include "coupling/quasi_static/wall.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "hydro/shell/filling.hpp"
#include "hydro/shell/growth.hpp"

namespace shmoo::coupling {
namespace {

constexpr double most_stretch = 1.1;  // since the reference
constexpr double last_stretch = 1.5;  // beyond which the old columns are worth nothing
constexpr int most_parts = 64;        // of a step that finds no equilibrium

}  // namespace

Wall::Wall(const WallPlan& plan) : plan_(plan), shell_(plan.start), equilibrium_(plan.start), filling_(plan.filling) {
  fill();
}

bool Wall::settle() {
  const auto balance = equilibrium_.find(shell_, plan_.scene.mechanics.turgor, plan_.tolerance);
  iterations_ += balance.iterations;
  if (balance.converged) residual_ = std::max(residual_, balance.residual / plan_.force_scale);
  return balance.converged;
}

void Wall::change(double dt, const std::vector<std::vector<double>>& concentration) {
  const auto& elastic = plan_.elastic();
  if (elastic.growth)
    hydro::grow(shell_, equilibrium_.energy(), *elastic.growth, concentration[std::size_t(elastic.growth->species)],
                dt);
  if (!elastic.softening) return;
  const auto& by = concentration[std::size_t(elastic.softening->species)];
  for (std::size_t i = 0; i < shell_.size(); ++i)
    shell_.shear[i] = hydro::softened(elastic.shear_modulus, *elastic.softening, by[i]);
}

void Wall::advance(double t, double dt, const std::vector<std::vector<double>>& concentration) {
  const auto before = shell_;
  for (int parts = 1; parts <= most_parts; parts *= 2) {
    shell_ = before;
    int done = 0;
    while (done < parts) {
      change(dt / parts, concentration);
      if (!settle()) break;
      ++done;
    }
    if (done < parts) continue;
    fill();
    return;
  }
  give_up(t);
}

// The filling follows the cavity.
void Wall::fill() {
  const auto outline = equilibrium_.energy().cavity(shell_);
  hydro::relax(filling_, outline);
  for (const auto& x : filling_) outside_ += hydro::inside(outline, x) ? 0 : 1;
}

void Wall::give_up(double t) const {
  throw base::RunError(
      fmt::format("the wall finds no equilibrium under its turgor of {:.4g} Pa at t = {:.6g} s: it is too soft for it "
                  "by now (least shear modulus {:.3g} Pa) or has grown too thin; lower mechanics.turgor, the softening "
                  "or the growth, or make domain.spacing smaller",
                  plan_.scene.mechanics.turgor, t, *std::min_element(shell_.shear.begin(), shell_.shear.end())));
}

std::vector<hydro::Take> Wall::rezone(double t) {
  const double stretch = hydro::largest_stretch(shell_, equilibrium_.energy());
  if (stretch <= most_stretch) return {};
  const auto before = shell_;
  auto takes = hydro::rezone(shell_, equilibrium_.energy());
  equilibrium_.energy().refer(shell_);
  if (settle()) {
    fill();
    return takes;
  }
  if (stretch > last_stretch) give_up(t);
  shell_ = before;  // later, perhaps
  equilibrium_.energy().refer(shell_);
  return {};
}

std::vector<double> Wall::volumes() const {
  std::vector<double> all;
  for (std::size_t i = 0; i < shell_.size(); ++i)
    all.push_back(plan_.real_volume(shell_.V0[i] * equilibrium_.energy().elastic(shell_, i).J()));
  return all;
}

double Wall::cavity_volume() const { return plan_.real_volume(equilibrium_.energy().cavity_volume(shell_)); }

double Wall::spacing() const {
  double largest = 0.0;
  for (int k = 0; k < shell_.columns; ++k) {
    for (int l = 0; l < shell_.layers; ++l) {
      const auto& here = shell_.x[shell_.at(k, l)];
      if (k > 0) largest = std::max(largest, (here - shell_.x[shell_.at(k - 1, l)]).norm());
      if (l > 0) largest = std::max(largest, (here - shell_.x[shell_.at(k, l - 1)]).norm());
    }
  }
  return largest;
}

}  // namespace shmoo::coupling
