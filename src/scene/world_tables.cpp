// The schema of space: the file itself, the domain, and what fills it.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

Key parameters_key() {
  return {"parameters",
          {named({unit_later("a number with any unit"), number(any)}, "the name of a parameter")},
          false,
          "{}",
          "named numbers and quantities that expressions can use, in SI units"};
}

Table file_table() {
  return {"",
          "the file",
          "One file describes a whole case.",
          {{"title", {text("any text")}, false, "\"\"", "what the case is, in one line"},
           {"dimension", {integer(1, 3)}, true, "", "dimensions of space", Place::space},
           {"axisymmetric",
            {boolean()},
            false,
            "false",
            "2-D, quasi-static mechanics only: the scene is turned about the x axis, and y is the distance from it",
            Place::space},
           {"depth",
            {quantity(dimensions::length, positive)},
            false,
            "",
            "2-D only: the thickness that a particle stands for; needed where there are species, a fluid or a solid",
            Place::space},
           {"cross_section",
            {quantity(dimensions::area, positive)},
            false,
            "",
            "1-D only: the area that a particle stands for; needed where there are species, a fluid or a solid",
            Place::space},
           {"network",
            {text("the path of an SBML file, from here")},
            false,
            "",
            "an SBML network in place of what this file would say of it; what the file says itself goes before",
            Place::well},
           {"compartments",
            {named({subtable("compartment")}, "the name of a compartment")},
            true,
            "",
            "in place of `domain`, `materials` and all else that is space: the scene is one well, mixed at all times",
            Place::well},
           {"domain", {subtable("domain")}, true, "", "size, spacing and sides", Place::space},
           {"materials",
            {named({subtable("material")}, "the name of a material")},
            true,
            "",
            "what fills space, by name",
            Place::space},
           {"region",
            {list({subtable("region")})},
            false,
            "[]",
            "where the materials are; later regions overwrite earlier ones",
            Place::space},
           {"refinement", {list({subtable("refinement")})}, false, "[]", "zones of a finer spacing", Place::space},
           parameters_key(),
           {"definitions",
            {named({expression("a formula"), number(any)}, "the name of a definition")},
            false,
            "{}",
            "names that stand for formulas, wherever these are read"},
           {"species",
            {named({subtable("species")}, "the name of a species")},
            false,
            "{}",
            "what diffuses and reacts, by name"},
           {"initial",
            {list({subtable("initial")})},
            false,
            "[]",
            "initial amounts besides those of [species.NAME]; later ones overwrite earlier ones"},
           {"reaction", {list({subtable("reaction")})}, false, "[]", "reactions"},
           {"event", {list({subtable("event")})}, false, "[]", "what happens at a time or a condition", Place::well},
           {"boundary",
            {list({subtable("boundary")})},
            false,
            "[]",
            "what species do at sides of the domain and at surfaces of materials; elsewhere they are reflected",
            Place::space},
           {"buoyancy",
            {list({subtable("buoyancy")})},
            false,
            "[]",
            "species that make the fluid lighter or heavier",
            Place::space},
           {"inflow",
            {list({subtable("inflow")})},
            false,
            "[]",
            "zones in which velocity and concentrations relax towards given values",
            Place::space},
           {"flow", {subtable("flow")}, false, "{}", "what drives the fluid, and its scales", Place::space},
           {"effects", {subtable("effects")}, false, "{}", "what is computed", Place::space},
           {"mechanics", {subtable("mechanics")}, false, "{}", "how solids move", Place::space},
           {"numerics", {subtable("numerics")}, false, "{}", "how it is computed"},
           {"observable", {list({subtable("observable")})}, false, "[]", "named numbers and profiles to record"},
           {"run", {subtable("run")}, true, "", "how long, how often, what to keep"}}};
}

Table domain_table() {
  return {
      "domain",
      "[domain]",
      "The box that is simulated.",
      {{"size", {per_axis({quantity(dimensions::length, positive)})}, true, "", "lengths of the box, one per axis"},
       {"spacing",
        {quantity(dimensions::length, positive)},
        true,
        "",
        "distance of neighbouring particles at the start"},
       {"origin", {position()}, false, "0 on every axis", "lower corner of the box"},
       {"boundary",
        {choice({"periodic", "wall", "reflect", "slip"}), subtable("sides")},
        false,
        "\"reflect\"",
        "all sides at once, or a table of sides"},
       {"material",
        {text("the name of a material")},
        false,
        "the only fluid, else the only still material; nothing where all is solid",
        "what fills all that no region covers; \"nothing\" for no particles"},
       {"jitter",
        {number({0, 0.5})},
        false,
        "0",
        "random displacement of each starting position, uniform up to this many spacings either way on every axis"}}};
}

Table sides_table() {
  const std::vector<Form> side{choice({"periodic", "wall", "reflect", "slip", "outlet"}), subtable("side")};
  std::vector<Key> keys;
  for (std::string_view name : {"x", "y", "z"})
    keys.push_back({name, side, false, "\"reflect\"", "both sides that this axis ends in"});
  for (std::string_view name : {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"})
    keys.push_back({name, side, false, "as its axis", "one side"});
  return {"sides", "domain.boundary",
          "The sides of the domain: \"periodic\", \"wall\" (no slip for the fluid, reflects species), \"reflect\" "
          "(reflects species), \"slip\" (a mirror for the fluid, reflects species), \"inlet\" or \"outlet\" (the fluid "
          "passes).",
          std::move(keys)};
}

Table side_table() {
  return {
      "side",
      "a side of domain.boundary",
      "A side that is more than its type.",
      {{"type",
        {choice({"periodic", "wall", "reflect", "slip", "inlet", "outlet"})},
        true,
        "",
        "what the side does; inlets and outlets are all on one axis"},
       {"velocity",
        {per_axis({quantity(dimensions::speed, any), expression("a formula for a velocity")})},
        false,
        "at rest",
        "of a wall: quantities, with which it slides along itself; of an inlet: what enters, quantities or formulas "
        "of x, y, z, t and the parameters"},
       {"pressure",
        {quantity(dimensions::pressure, any)},
        false,
        "\"0 Pa\" at an outlet",
        "held at an outlet, or at an inlet in place of a velocity"},
       {"species",
        {named({quantity(dimensions::concentration, not_negative)}, "the name of a species")},
        false,
        "none",
        "concentrations in what enters through an inlet or an outlet, `{ A = \"10 nM\" }`; what leaves takes along "
        "what it holds"}}};
}

Table material_table() {
  const auto turning =
      std::vector<Form>{quantity(dimensions::frequency, any), list({quantity(dimensions::frequency, any)}, 3, 3)};
  Table table{
      "material",
      "[materials.NAME]",
      "A fluid flows where the flow is on. A wall is rigid and does not slip. A solid is elastic; each is one body, "
      "and bodies feel each other through the fluid only. A still material never moves and does not act on a fluid: "
      "gels, "
      "slabs, wells of pure chemistry.",
      {{"type", {choice({"fluid", "wall", "solid", "still"})}, true, "", "what kind of material it is"},
       {"density",
        {quantity(dimensions::density, positive)},
        false,
        "",
        "of a solid, and of a fluid where the flow is on; needed there"},
       {"viscosity",
        {quantity(dimensions::viscosity, positive)},
        false,
        "",
        "dynamic shear viscosity of a fluid; needed where the flow is on"},
       {"bulk_viscosity", {quantity(dimensions::viscosity, not_negative)}, false, "\"0 Pa s\"", "of a fluid"},
       {"velocity", {velocity()}, false, "at rest", "of a wall, or the held part of a solid, whose particles move"},
       {"angular_velocity", turning, false, "at rest",
        "of a wall, or the held part of a solid, whose particles turn round `center`: one quantity in 2-D, three in "
        "3-D"},
       {"surface_velocity", {velocity()}, false, "at rest", "of a wall whose surface slides while its particles stay"},
       {"surface_angular_velocity", turning, false, "at rest",
        "of a wall whose surface turns round `center` while its particles stay"},
       {"strain_rate",
        {list({quantity(base::power(dimensions::time, -1), any)}, 1, 3)},
        false,
        "none",
        "of a wall whose particles move away from `center`, one rate for each axis: a box that is drawn out"},
       {"moves_until", {quantity(dimensions::time, positive)}, false, "for ever", "when such a motion ends"},
       {"center", {position()}, false, "", "what an angular velocity turns round, or a strain rate moves away from"}}};
  for (Key& key : solid_keys()) table.keys.push_back(std::move(key));
  return table;
}

Table region_table() {
  return {"region",
          "[[region]]",
          "A shape filled with a material.",
          {{"material", {text("the name of a material")}, true, "", "what fills it"}},
          ShapeUse::required};
}

Table part_table() {
  return {
      "part", "a shape of a union or difference", "A shape inside another; at most 32 deep.", {}, ShapeUse::required};
}

}  // namespace

std::vector<Table> world_tables() {
  return {file_table(),     domain_table(),    sides_table(),  side_table(),
          material_table(), softening_table(), region_table(), part_table()};
}

}  // namespace shmoo::scene
