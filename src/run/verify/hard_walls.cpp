// Walls and fluids under strain: pressures far below zero, fluids that collide.
#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

using Fluid = hydro::Fluid<2>;
using base::Vec;

// Fluid that is torn apart: the pressure falls far below zero, where particles attract and clump.
std::vector<Finding> stretched_patch() {
  const auto scene = scene_of(square("0.025 m", "0.01 Pa s", periodic, R"toml([parameters]
U = "3 m/s"
k = "6.283185307179586 1/m"
[flow]
initial_velocity = ["-U * sin(k*x)*cos(k*y)", "U * cos(k*x)*sin(k*y)"]
reference_speed = "3 m/s"
)toml"));
  Fluid fluid(scene, sph::fill<2>(scene));
  double lowest = 0.0, distance = 1.0;
  for (int look = 0; look < 100; ++look) {
    fluid.advance(0.01 * (look + 1));
    for (const std::uint32_t i : fluid.state().rows.fluid()) lowest = std::min(lowest, fluid.state().pressure[i]);
    distance = std::min(distance, fluid.smallest_distance());
  }
  return {at_most("lowest pressure, in rho U^2", lowest / 9.0, -0.1),
          at_least("smallest distance of particles, in spacings", distance, 0.5),
          at_most("largest density error", fluid.density_error(), 0.03)};
}

// Two halves of a fluid run into each other at the speed of sound: shocks, and behind them a tear; or all of it runs
// into a wall and off the one behind.
scene::Scene collision(const std::string& spacing, const std::string& viscosity, const std::string& sides,
                       const std::string& velocity, const std::string& effects = "") {
  return scene_of(square(spacing, viscosity, sides,
                         "[parameters]\nU = \"1 m/s\"\nL = \"0.5 m\"\n[flow]\ninitial_velocity = [\"" + velocity +
                             "\", \"0 * U\"]\nsound_speed = \"1 m/s\"\nreference_length = \"1 m\"\n" + effects));
}
const std::string halves = "x < L ? U : -U";

// Mean density about the middle, in units of that at rest.
double shocked_density(const Fluid& fluid) {
  double sum = 0.0, count = 0.0;
  for (const std::uint32_t i : fluid.state().rows.fluid()) {
    if (std::abs(fluid.particles().position[i][0] - 0.5) > 0.05) continue;
    sum += fluid.state().density[i];
    count += 1.0;
  }
  return sum / count;
}

std::vector<Finding> collide(const std::string& name, const scene::Scene& scene) {
  Fluid fluid(scene, sph::fill<2>(scene));
  const double start = fluid.kinetic_energy();
  const auto seen = watch(fluid, 3.0, 60);
  double least = 1.0;
  for (const std::uint32_t i : fluid.state().rows.fluid()) least = std::min(least, fluid.state().density[i]);
  const double drift = fluid.momentum().norm() / (fluid.scales().mass * double(fluid.state().rows.fluid().size()));
  std::vector<Finding> findings{
      at_most(name + ": fastest particle ever, in speeds of sound", seen.speed, 1.5),
      at_most(name + ": kinetic energy at the end, of that at the start", fluid.kinetic_energy() / start, 0.2),
      at_least(name + ": least density at the end, of that at rest", least, 0.5),
      exactly(name + ": particles outside", seen.outside, 0.0)};
  if (fluid.box().periodic[0]) findings.push_back(at_most(name + ": mean velocity, in speeds of sound", drift, 1e-12));
  return findings;
}

// A shock into an isothermal gas that it stops from Mach 1 multiplies density by ((1 + sqrt 5)/2)^2 (Rankine,
// Hugoniot).
std::vector<Finding> impact() {
  const auto scene = collision("0.025 m", "0.001 Pa s", periodic, halves);
  Fluid fluid(scene, sph::fill<2>(scene));
  fluid.advance(0.15);
  std::vector<Finding> findings{
      within("density behind a shock, over that at rest", shocked_density(fluid), 0.95 * 2.618, 1.05 * 2.618)};
  const std::string walls = R"({ x = "wall", y = "wall" })";
  for (const auto& part : {collide("viscosity 0.001", scene),
                           collide("no viscosity, 24^2", collision("0.0416666666667 m", "0.001 Pa s", periodic, halves,
                                                                   "[effects]\nviscosity = false\n")),
                           collide("against walls", collision("0.025 m", "0.001 Pa s", walls, "U"))})
    findings.insert(findings.end(), part.begin(), part.end());
  return findings;
}

}  // namespace

std::vector<Case> hard_walls() {
  return {{"stretched-patch", "pressures far below zero where fluid is torn apart", stretched_patch},
          {"impact", "two halves of a fluid collide at Mach 1, and a fluid with walls", impact}};
}

}  // namespace shmoo::run::verify
