// Elastic solids in a fluid: as light as it, thin, soft, turning, too thin.
#include <fmt/format.h>

#include "base/error.hpp"
#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

struct Solid {
  const char *shear_modulus, *density, *shape;
  const char* more = "";
};

const char* const disk = "shape = \"disk\"\ncenter = [\"0.5 m\", \"0.5 m\"]\nradius = \"0.15 m\"\n";

// In a square of vortices of unit speed and density: the fluid's pressures are about 1 Pa.
scene::Scene in_vortices(const Solid& solid) {
  auto text = square("0.025 m", "0.01 Pa s", periodic,
                     vortices + fmt::format("[materials.body]\ntype = \"solid\"\npoisson_ratio = 0.4\n"
                                            "shear_modulus = \"{}\"\ndensity = \"{}\"\n{}\n[[region]]\n"
                                            "material = \"body\"\n{}",
                                            solid.shear_modulus, solid.density, solid.more, solid.shape));
  text.insert(text.find("boundary ="), "material = \"liquid\"\n");
  return scene_of(text);
}

// Nothing drives fluid and solid after the start, so their energy may only fall.
std::vector<Finding> drift_along(const Solid& solid) {
  const auto scene = in_vortices(solid);
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const auto energy = [&] {
    return fluid.kinetic_energy() + fluid.solids().kinetic_energy() + fluid.solids().elastic_energy();
  };
  const double start = energy();
  double last = start, rise = 0.0, speed = 0.0, error = 0.0;
  for (int k = 1; k <= 50; ++k) {
    fluid.advance(0.02 * k);
    rise = std::max(rise, (energy() - last) / start);
    last = energy();
    speed = std::max({speed, fluid.max_speed(), fluid.solids().max_speed()});
    error = std::max(error, fluid.density_error());
  }
  return {at_most("largest rise of energy, of that at the start", rise, 1e-3),
          within("energy left", last / start, 0.05, 0.5),
          at_most("fastest particle, in speeds of the vortices", speed, 1.2),
          at_most("largest density error", error, 0.05)};
}

std::vector<Finding> as_light_as_the_fluid() { return drift_along({"100 Pa", "1 kg/m^3", disk}); }
std::vector<Finding> ten_times_heavier() { return drift_along({"100 Pa", "10 kg/m^3", disk}); }
std::vector<Finding> soft_body() { return drift_along({"1 Pa", "1 kg/m^3", disk}); }

std::vector<Finding> thin_sheet() {
  return drift_along(
      {"10 Pa", "0.2 kg/m^3", "shape = \"box\"\nlower = [\"0.2 m\", \"0.5 m\"]\nupper = [\"0.8 m\", \"0.55 m\"]\n"});
}

// Ten turns in a fluid that brakes them hardly keep their shape.
std::vector<Finding> spinning_bar() {
  auto text = square("0.025 m", "1e-4 Pa s", periodic,
                     "[parameters]\nw = \"20 1/s\"\nc = \"0.5 m\"\n[materials.body]\ntype = \"solid\"\n"
                     "poisson_ratio = 0.3\nshear_modulus = \"1e4 Pa\"\ndensity = \"50 kg/m^3\"\n"
                     "initial_velocity = [\"-w*(y - c)\", \"w*(x - c)\"]\n[[region]]\nmaterial = \"body\"\n"
                     "shape = \"box\"\nlower = [\"0.35 m\", \"0.45 m\"]\nupper = [\"0.65 m\", \"0.55 m\"]\n");
  text.insert(text.find("boundary ="), "material = \"liquid\"\n");
  const auto scene = scene_of(text);
  hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  const auto& body = fluid.solids().bodies()[0];
  const auto span = [&] {
    return (body.start.back() + body.displacement.back() - body.start.front() - body.displacement.front()).norm();
  };
  const double length = span();
  double turned = 0.0, before = 0.0, stretch = 0.0;
  while (turned < 10.0 && fluid.time() < 6.0) {
    fluid.step();
    const base::Vec<2> along =
        body.start.back() + body.displacement.back() - body.start.front() - body.displacement.front();
    const double angle = std::atan2(along[1], along[0]);
    turned += std::remainder(angle - before, 2.0 * M_PI) / (2.0 * M_PI);
    before = angle;
    stretch = std::max(stretch, std::abs(span() / length - 1.0));
  }
  return {at_least("turns in 6 s", turned, 10.0), at_most("largest change of its diagonal", stretch, 0.02),
          at_most("largest density error", fluid.density_error(), 0.1)};
}

std::vector<Finding> one_particle_thick() {
  double refused = 0.0;
  try {
    const auto scene = in_vortices(
        {"100 Pa", "1 kg/m^3", "shape = \"box\"\nlower = [\"0.2 m\", \"0.5 m\"]\nupper = [\"0.8 m\", \"0.525 m\"]\n"});
    hydro::Fluid<2> fluid(scene, sph::fill<2>(scene));
  } catch (const base::InputError& error) {
    refused = std::string(error.what()).find("two particles thick") != std::string::npos;
  }
  return {exactly("refused, with what to do", refused, 1.0)};
}

}  // namespace

std::vector<Case> hard_solids() {
  return {{"solid-as-light-as-fluid", "an elastic disk of the fluid's density: the fluid's mass moves with it",
           as_light_as_the_fluid},
          {"solid-ten-times-heavier", "an elastic disk of ten times the fluid's density", ten_times_heavier},
          {"soft-solid", "an elastic disk a hundred times softer, as soft as the fluid's pressures", soft_body},
          {"thin-sheet", "a sheet two particles thick, a fifth of the fluid's density", thin_sheet},
          {"spinning-bar", "ten turns of a bar in a fluid", spinning_bar},
          {"one-particle-sheet", "a sheet one particle thick, which has no strain", one_particle_thick}};
}

}  // namespace shmoo::run::verify
