// Elastic solids: plates that swing alone, and one that swings in a fluid.
#include <fmt/format.h>

#include <cmath>

#include "base/clock.hpp"
#include "hydro/fluid.hpp"
#include "run/bench/workload.hpp"
#include "scene/read.hpp"
#include "sph/fill.hpp"

namespace shmoo::run::bench {
namespace {

// A plate of n particles through its thickness that starts to bend, with `law`.
std::string plate(int dimension, int n, const std::string& law) {
  const bool deep = dimension == 3;
  return fmt::format(
      "dimension = {0}\n{1}[domain]\nsize = [\"4 m\", \"2 m\"{2}]\nspacing = \"{3:.17g} m\"\nmaterial = \"nothing\"\n"
      "[parameters]\ns = \"1 1/s\"\nL = \"4 m\"\n[materials.plate]\ntype = \"solid\"\ndensity = \"1000 kg/m^3\"\n"
      "young_modulus = \"1e6 Pa\"\npoisson_ratio = 0.4\nlaw = \"{4}\"\ninitial_velocity = [\"0 m/s\", \"s*x*x/L\"{5}]\n"
      "[[region]]\nmaterial = \"plate\"\nshape = \"box\"\nlower = [\"0 m\", \"0.5 m\"{6}]\nupper = [\"4 m\", \"1.5 "
      "m\"{2}]\n"
      "[run]\nuntil = \"1 s\"\n",
      dimension, deep ? "" : "depth = \"1 m\"\n", deep ? ", \"1 m\"" : "", 1.0 / n, law, deep ? ", \"0 m/s\"" : "",
      deep ? ", \"0 m\"" : "");
}

// The same in a channel, held at one end.
std::string wet_plate() {
  auto text = plate(2, 20, "neo-hookean");
  const auto swap = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  swap("material = \"nothing\"", "material = \"liquid\"\nboundary = { x = \"periodic\", y = \"wall\" }");
  swap("[materials.plate]",
       "[materials.liquid]\ntype = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"10 Pa s\"\n[materials.plate]");
  swap("lower = [\"0 m\", \"0.5 m\"]", "lower = [\"1 m\", \"0.75 m\"]");
  swap("upper = [\"4 m\", \"1.5 m\"]", "upper = [\"3 m\", \"1.25 m\"]");
  return text;
}

template <int D>
Measurement dry_steps(const std::string& text, double seconds) {
  const auto scene = scene::read_scene_text(text, "bench.toml");
  const double before = allocated_bytes();
  hydro::Solids<D> solids(scene, sph::fill<D>(scene));
  const double particles = double(solids.bodies()[0].size()), energy = solids.kinetic_energy();
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / particles;
  double steps = 0.0, t = 0.0;
  const double start = base::cpu_seconds();
  do {
    const double dt = solids.step_limit();
    solids.advance(t, dt);
    t += dt;
    ++steps;
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate = particles * steps / measurement.cpu_seconds;
  const double error = std::abs((solids.kinetic_energy() + solids.elastic_energy()) / energy - 1.0);
  measurement.right = error < 0.01;
  measurement.check = fmt::format("energy changed by {:.2g} in {:g} steps", error, steps);
  return measurement;
}

Measurement wet_steps(double seconds) {
  const auto scene = scene::read_scene_text(wet_plate(), "bench.toml");
  const double before = allocated_bytes();
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene), {1, 0});
  const double particles = double(fluid.state().rows.fluid().size() + fluid.solids().bodies()[0].size());
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / particles;
  const double start = base::cpu_seconds();
  do {
    fluid.step();
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate = particles * double(fluid.steps()) / measurement.cpu_seconds;
  measurement.right = fluid.density_error() < 0.1;
  measurement.check = fmt::format("largest density error {:.2g} after {} steps", fluid.density_error(), fluid.steps());
  return measurement;
}

}  // namespace

std::vector<Workload> solid_workloads() {
  const std::string unit = "particle-steps per CPU second";
  std::vector<Workload> all;
  for (const std::string law : {"neo-hookean", "saint-venant-kirchhoff"}) {
    all.push_back({"SOLID2D-20", law, unit, [law](double s) { return dry_steps<2>(plate(2, 20, law), s); }});
    all.push_back({"SOLID3D-10", law, unit, [law](double s) { return dry_steps<3>(plate(3, 10, law), s); }});
  }
  all.push_back({"FSI2D-20", "neo-hookean", unit, [](double s) { return wet_steps(s); }});
  return all;
}

}  // namespace shmoo::run::bench
