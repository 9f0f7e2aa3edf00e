// Walls in equilibrium under turgor: too soft, at the limit load, growing fast, too thin; and a solid turned all the
// way.
#include <fmt/format.h>

#include "base/error.hpp"
#include "coupling/laboratory.hpp"
#include "hydro/solid/solids.hpp"
#include "run/verify/flow_watch.hpp"

namespace shmoo::run::verify {
namespace {

struct Cell {
  const char* turgor = "0.03 MPa";
  const char* spacing = "0.8 um";  // three layers
  const char* softening = "0.99 m^3/mol";
  const char* growth = "1e-9 m^3/(mol MPa s)";  // as good as none
  const char* start = "0 mol/m^3";              // of the enzyme, everywhere
  const char* tip = "0.9 mol/m^3";
};

// A coarse yeast cell, 100 s.
std::string text_of(const Cell& cell) {
  return fmt::format(R"toml(dimension = 2
axisymmetric = true
[domain]
origin = ["-16 um", "0 um"]
size = ["60 um", "16 um"]
spacing = "{}"
material = "nothing"
[materials.wall]
type = "solid"
density = "1100 kg/m^3"
shear_modulus = "0.358 MPa"
poisson_ratio = 0.3975
softening = {{ species = "E", coefficient = "{}", least = 0.01 }}
growth = {{ species = "E", coefficient = "{}" }}
[materials.cytoplasm]
type = "still"
[[region]]
material = "wall"
shape = "ring"
center = ["0 um", "0 um"]
radius = ["7.5 um", "10 um"]
[[region]]
material = "cytoplasm"
shape = "disk"
center = ["0 um", "0 um"]
radius = "7.5 um"
[species.E]
in = "wall"
method = "deterministic"
diffusivity = "1e-12 m^2/s"
initial = "{}"
[[reaction]]
equation = "E ->"
forward = "0.1 1/s"
[mechanics]
motion = "quasi-static"
turgor = "{}"
step = "10 s"
columns = 40
[[mechanics.source]]
species = "E"
rate = "20 1/s"
concentration = "{}"
width = "1.5 um"
[[observable]]
name = "length"
type = "projection_length"
[[observable]]
name = "residual"
type = "residual"
[[observable]]
name = "outside"
type = "outside"
[run]
until = "100 s"
record_every = "20 s"
)toml",
                     cell.spacing, cell.softening, cell.growth, cell.start, cell.turgor, cell.tip);
}

// Its laws where it lives; `most` [m]: allowed of its extension.
std::vector<Finding> lives(const Cell& cell, double least, double most) {
  const coupling::Laboratory lab(scene_of(text_of(cell)));
  const auto last = [&](const char* name) { return lab.shared.observed(name, 5)[0]; };
  coupling::Outcome outcome;
  lab.realise(0, &outcome);
  double present = 0.0;
  for (const double amount : lab.shared.at("E", 5)) present += amount;
  const auto& account = outcome.ledger.amounts[0];
  return {within("extension [m]", last("length"), least, most),
          at_most("largest residual of an equilibrium, of p R^2", last("residual"), 1e-8),
          exactly("particles outside the cavity, any step", last("outside"), 0.0),
          at_most("what the ledger misses, of what entered", std::abs(present - account.expected()) / account.entered,
                  1e-12)};
}

// Refused with a message that has all of these words.
std::vector<Finding> refused(const Cell& cell, std::initializer_list<const char*> words) {
  std::string message;
  try {
    const coupling::Laboratory lab(scene_of(text_of(cell)));
  } catch (const base::InputError& error) {
    message = error.what();
  } catch (const base::RunError& error) {
    message = error.what();
  }
  std::vector<Finding> findings;
  for (const char* word : words)
    findings.push_back(
        exactly(fmt::format("refused, saying \"{}\"", word), message.find(word) != std::string::npos, 1.0));
  return findings;
}

std::vector<Finding> tip_at_a_hundredth() { return lives({.turgor = "0.003 MPa", .tip = "2 mol/m^3"}, 0.1e-6, 1e-6); }
std::vector<Finding> wall_at_a_hundredth() {
  return refused({.start = "3 mol/m^3"}, {"no equilibrium", "t = ", "least shear modulus"});
}
std::vector<Finding> below_the_limit_load() { return lives({.turgor = "0.1 MPa", .tip = "0.01 mol/m^3"}, 0.0, 0.1e-6); }
std::vector<Finding> beyond_the_limit_load() { return refused({.turgor = "0.12 MPa"}, {"limit load", "Pa only"}); }
std::vector<Finding> fast_growth() { return lives({.growth = "2 m^3/(mol MPa s)"}, 10e-6, 20e-6); }
std::vector<Finding> one_layer() { return refused({.spacing = "2 um"}, {"spacings thick", "at least 2"}); }
std::vector<Finding> two_layers() { return lives({.spacing = "1.25 um"}, -1e-6, 1e-6); }

// Every particle is held and carried round; what its law makes of that is stress.
std::vector<Finding> turned_all_the_way() {
  const auto scene = scene_of(R"toml(dimension = 2
depth = "1 m"
[domain]
size = ["2 m", "2 m"]
spacing = "0.1 m"
material = "nothing"
[materials.bar]
type = "solid"
density = "1000 kg/m^3"
shear_modulus = "1e6 Pa"
poisson_ratio = 0.3
angular_velocity = "6.283185307179586 1/s"
center = ["1 m", "1 m"]
fixed = { shape = "box", lower = ["0 m", "0 m"], upper = ["2 m", "2 m"] }
[[region]]
material = "bar"
shape = "box"
lower = ["0.4 m", "0.8 m"]
upper = ["1.6 m", "1.2 m"]
[run]
until = "1 s"
)toml");
  hydro::Solids<2> solids(scene, sph::fill<2>(scene));
  double stress = 0.0, back = 0.0;
  const auto& body = solids.bodies()[0];
  for (int k = 0; k < 60; ++k) {
    solids.advance(k / 60.0, 1.0 / 60.0);
    for (std::size_t i = 0; i < body.size(); ++i)
      stress = std::max(stress, std::abs(solids.pressure(body, i)) / body.shear);
  }
  for (const auto& u : body.displacement) back = std::max(back, u.norm());
  return {at_most("largest pressure on the way, of G", stress, 1e-10),
          at_most("where a particle ends, from where it began [m]", back, 1e-9),
          at_most("elastic energy, of G times the volume", solids.elastic_energy() / (1e6 * 0.48), 1e-20)};
}

}  // namespace

std::vector<Case> hard_shells() {
  return {{"tip-at-a-hundredth", "a wall whose tip keeps a hundredth of its modulus", tip_at_a_hundredth},
          {"wall-at-a-hundredth", "a wall that softens all round beneath its turgor", wall_at_a_hundredth},
          {"below-limit-load", "a turgor close to what the wall bears", below_the_limit_load},
          {"beyond-limit-load", "a turgor that no equilibrium bears", beyond_the_limit_load},
          {"fast-growth", "a wall that grows by more than its length between two pictures", fast_growth},
          {"two-layer-wall", "a wall of two layers", two_layers},
          {"one-layer-wall", "a wall of one layer, which has no strain across", one_layer},
          {"turned-all-the-way", "an elastic bar carried round by 360 degrees", turned_all_the_way}};
}

}  // namespace shmoo::run::verify
