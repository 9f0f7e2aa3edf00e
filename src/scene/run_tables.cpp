// The schema of running: numerics, observables, how long and what to keep.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

Table numerics_table() {
  return {
      "numerics",
      "[numerics]",
      "How it is computed. The defaults are safe.",
      {{"kernel",
        {choice({"lucy", "cubic_spline", "quintic_spline", "wendland_c2"})},
        false,
        "\"wendland_c2\"",
        "smoothing kernel"},
       {"reach",
        {number({1.05, 8})},
        false,
        "3",
        "radius of the kernel, in spacings; below 1.4 a lattice has nearest neighbours only (for chemistry at rest)"},
       {"pressure",
        {choice({"auto", "symmetric", "difference", "riemann"})},
        false,
        "\"auto\"",
        "form of the pressure gradient: symmetric, which conserves momentum; by differences, which is more accurate "
        "and "
        "does not; what Riemann problems between pairs give (Zhang, Hu & Adams 2017), which conserves momentum and "
        "withstands shocks; auto: symmetric, or riemann where the reference speed is beyond Mach 0.3"},
       {"density",
        {choice({"auto", "continuity", "summation"})},
        false,
        "\"auto\"",
        "how density follows the particles: integrated from the divergence of the velocity, or summed over the "
        "particles about; auto: summation with thermal noise, or beyond Mach 0.3 where the fluid fills its room and "
        "nothing "
        "else is said of pressure and density, else continuity"},
       {"shepard_every",
        {integer(0, 1000000)},
        false,
        "0",
        "densities by continuity are renormalised (Shepard filter) every so many steps; 0: never"},
       {"viscous_step",
        {choice({"auto", "explicit", "implicit"})},
        false,
        "\"auto\"",
        "how friction inside the fluid is stepped: implicit where its explicit step limit would be far below the "
        "acoustic"},
       {"walls",
        {choice({"auto", "extrapolated", "second-order"})},
        false,
        "\"auto\"",
        "what a fluid sees behind a wall: velocities mirrored (Adami, Hu & Adams 2012), or continued as a parabola "
        "behind "
        "the true surface, where that is smooth; by rule"},
       {"courant", {number({0, 1, true, false})}, false, "0.25", "of the acoustic time step"},
       {"sampler",
        {choice({"direct", "composition_rejection", "split", "tau_leaping", "auto"})},
        false,
        "\"composition_rejection\"",
        "how stochastic events are drawn: exact and plain, exact and fast, diffusion split from reactions, or so "
        "and reactions in leaps; by rule"},
       {"splitting", {choice({"lie", "strang"})}, false, "\"strang\"", "first or second order in the splitting step"},
       {"splitting_step",
        {quantity(dimensions::time, positive)},
        false,
        "derived",
        "time between exchanges of flow, deterministic and stochastic chemistry"},
       {"splitting_tolerance",
        {number({1e-6, 0.1})},
        false,
        "1e-3",
        "error of amounts that the derived splitting step may cost, relative"},
       {"tolerance", {number({1e-14, 0.1})}, false, "1e-6", "relative, of deterministic chemistry"},
       {"leap_tolerance",
        {number({1e-6, 0.5})},
        false,
        "0.03",
        "relative change of a propensity in a leap (Cao, Gillespie & Petzold 2006), and of an amount in a Langevin "
        "step"},
       {"method",
        {choice({"stochastic", "langevin", "deterministic", "auto"})},
        false,
        "\"stochastic\"",
        "method of the species that name none"},
       {"limits",
        {choice({"refuse", "warn"})},
        false,
        "\"refuse\"",
        "what happens where a number of the scene is beyond a limit of `shmoo explain` that makes a run worthless"},
       {"steady_tolerance",
        {number({0, 1, true, true})},
        false,
        "never",
        "relative change of the flow per crossing time below which it is taken as steady"}}};
}

Table observable_table() {
  const Form axis = choice({"x", "y", "z"});
  return {"observable",
          "[[observable]]",
          "A number or profile that is recorded under its name.",
          {{"name", {text("letters, digits, _ and -")}, true, "", "what it is called"},
           {"type",
            {choice({"count",          "concentration", "profile",           "kinetic_energy",   "max_speed",
                     "temperature",    "density_error", "min_distance",      "velocity_profile", "displacement",
                     "elastic_energy", "solid_energy",  "velocity_line",     "species_line",     "wall_force",
                     "wall_torque",    "species_flux",  "projection_length", "tip_curvature",    "flank_curvature",
                     "cavity_volume",  "residual",      "outside",           "bounces"})},
            true,
            "",
            "count: molecules of a species; concentration: the same per volume; profile: the same along an axis; "
            "displacement: mean over what started in `shape`, elastic_energy and solid_energy (elastic and kinetic) of "
            "solids; lines: "
            "values at single points, by moving least squares; wall_force, wall_torque: of the fluid on a wall; "
            "species_flux: "
            "molecules per time that enter through a boundary, less those that leave; projection_length (from tip to "
            "back, less that before growth), tip_curvature, "
            "flank_curvature (the least of the front half, times the outer radius; negative: a concave neck), "
            "cavity_volume, residual (largest force that an equilibrium left, of turgor times radius squared) and "
            "outside (particles found outside the cavity) of a quasi-static wall; the others belong to the fluid"},
           {"species", {text("the name of a species")}, false, "", "for what is measured of a species"},
           {"in",
            {text("the name of a material")},
            false,
            "all in which it lives",
            "only in this material, or solid; for a force, torque or flux: at its surface",
            Place::space},
           {"side",
            {choice({"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"})},
            false,
            "",
            "of the domain, where a force, torque or flux is measured, or `in`",
            Place::space},
           {"axis", {axis}, false, "\"x\"", "along which a profile or line runs", Place::space},
           {"component", {axis}, false, "\"x\"", "of a velocity, displacement, force or, in 3-D, torque", Place::space},
           {"bins", {integer(1, 1000000)}, false, "one per spacing", "of a profile or line", Place::space},
           {"through", {position()}, false, "", "a point of the line", Place::space},
           {"about", {position()}, false, "", "the point about which a torque acts", Place::space},
           {"at",
            {list({quantity(dimensions::length, any)}, 1, 1000000)},
            false,
            "the middles of the bins",
            "coordinates of a line's points along its axis, ascending",
            Place::space}},
          ShapeUse::optional};
}

Table run_table() {
  return {"run",
          "[run]",
          "How long, how often, what to keep.",
          {{"until", {quantity(dimensions::time, positive)}, true, "", "end of the simulated time"},
           {"record_every", {quantity(dimensions::time, positive)}, false, "a tenth of `until`", "interval of records"},
           {"record_at",
            {list({quantity(dimensions::time, not_negative)}, 0, 1000000)},
            false,
            "[]",
            "further times to record"},
           {"realisations", {integer(1, 1e7)}, false, "1", "how many runs with different chance"},
           {"seed", {integer(0, infinite)}, false, "1", "what all chance follows from"},
           {"record",
            {list({text("the name of a species or field")}, 1)},
            false,
            "all fields",
            "fields to keep: names of species, `position`, `velocity`, `density`, `pressure`, `volume`"},
           {"quantiles",
            {list({number({0, 1, true, true})}, 0, 100)},
            false,
            "[0.05, 0.5, 0.95]",
            "quantiles over the realisations, ascending"}}};
}

}  // namespace

std::vector<Table> run_tables() { return {numerics_table(), observable_table(), run_table()}; }

}  // namespace shmoo::scene
