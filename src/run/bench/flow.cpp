#include <fmt/format.h>

#include "base/clock.hpp"
#include "hydro/fluid.hpp"
#include "run/bench/workload.hpp"
#include "scene/read.hpp"
#include "sph/fill.hpp"

namespace shmoo::run::bench {
namespace {

// Vortices in a periodic box of n particles an axis; `extra` goes to [effects] and [flow].
std::string box_of(int dimension, int n, double reach, const std::string& flow, const std::string& effects) {
  const bool solid = dimension == 3;
  const std::string third = solid ? ", \"1 m\"" : "";
  return fmt::format(
      "title = \"bench\"\ndimension = {}\n{}[domain]\nsize = [\"1 m\", \"1 m\"{}]\nspacing = \"{:.17g} m\"\n"
      "boundary = {{ x = \"periodic\", y = \"periodic\"{} }}\n[materials.liquid]\ntype = \"fluid\"\n"
      "density = \"1 kg/m^3\"\nviscosity = \"0.01 Pa s\"\n[parameters]\nU = \"1 m/s\"\nk = \"6.283185307179586 1/m\"\n"
      "[flow]\ninitial_velocity = [\"-U * cos(k*x) * sin(k*y)\", \"U * sin(k*x) * cos(k*y)\"{}]\n"
      "reference_speed = \"1 m/s\"\n{}[effects]\n{}[numerics]\nreach = {:g}\n[run]\nuntil = \"1 s\"\n",
      dimension, solid ? "" : "depth = \"1 m\"\n", third, 1.0 / n, solid ? ", z = \"periodic\"" : "",
      solid ? ", \"0 m/s\"" : "", flow, effects, reach);
}

const char* const cavity = R"toml(
title = "bench"
dimension = 2
depth = "1 m"
[domain]
size = ["1 m", "1 m"]
spacing = "0.01 m"
boundary = { x = "wall", y = "wall", y_max = { type = "wall", velocity = ["1 m/s", "0 m/s"] } }
[materials.liquid]
type = "fluid"
density = "1 kg/m^3"
viscosity = "0.01 Pa s"
[run]
until = "1 s"
)toml";

template <int D>
Measurement whole_steps(const std::string& text, double seconds) {
  const auto scene = scene::read_scene_text(text, "bench.toml");
  const double before = allocated_bytes();
  hydro::Fluid<D> fluid(scene, sph::fill<D>(scene), {1, 0});
  const double particles = double(fluid.state().rows.fluid().size());
  for (int warm = 0; warm < 5; ++warm) fluid.step();
  Measurement measurement;
  measurement.bytes_per_voxel = (allocated_bytes() - before) / particles;
  const auto done = fluid.steps();
  const double start = base::cpu_seconds();
  do {
    fluid.step();
    measurement.cpu_seconds = base::cpu_seconds() - start;
  } while (measurement.cpu_seconds < seconds);
  measurement.rate = particles * double(fluid.steps() - done) / measurement.cpu_seconds;
  measurement.right = fluid.density_error() < 0.1;
  measurement.check = fmt::format("largest density error {:.2g} after {} steps", fluid.density_error(), fluid.steps());
  return measurement;
}

template <int D>
void add(std::vector<Workload>& all, const std::string& name, const std::string& method, const std::string& text) {
  all.push_back({name, method, "particle-steps per CPU second",
                 [text](double seconds) { return whole_steps<D>(text, seconds); }});
}

}  // namespace

std::vector<Workload> flow_workloads() {
  const std::string plain = "transport_velocity = false\ndensity_diffusion = false\n", all_on;
  const std::string noisy = "thermal_energy = \"1e-8 J\"\n",
                    noise = "thermal_noise = true\ntransport_velocity = false\n";
  std::vector<Workload> all;
  for (const int n : {100, 400}) {
    add<2>(all, fmt::format("SPH2D-{}", n), "plain", box_of(2, n, 3.0, "", plain));
    add<2>(all, fmt::format("SPH2D-{}", n), "all-on", box_of(2, n, 3.0, "", all_on));
  }
  for (const double reach : {2.0, 3.0}) {
    for (const int n : {32, 64})
      add<3>(all, fmt::format("SPH3D-{}", n), fmt::format("plain-reach-{:g}", reach), box_of(3, n, reach, "", plain));
  }
  add<2>(all, "SDPD2D-100", "noise", box_of(2, 100, 3.0, noisy, noise));
  add<3>(all, "SDPD3D-24", "noise", box_of(3, 24, 2.0, noisy, noise));
  add<2>(all, "CAVITY-100", "all-on", cavity);
  return all;
}

}  // namespace shmoo::run::bench
