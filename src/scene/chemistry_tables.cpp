// The schema of chemistry: species, their initial amounts, reactions, boundaries.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

constexpr std::string_view a_species = "the name of a species";
constexpr std::string_view a_material = "the name of a material";

Form concentration() { return quantity(dimensions::concentration, not_negative); }

Table species_table() {
  return {"species",
          "[species.NAME]",
          "A kind of molecule. Its name can be used in equations and expressions.",
          {{"in", one_or_more(a_material), false, "all materials that are not walls", "materials in which it lives"},
           {"diffusivity",
            {quantity(dimensions::diffusivity, not_negative)},
            false,
            "\"0 m^2/s\"",
            "diffusion coefficient"},
           {"method",
            {choice({"stochastic", "deterministic", "auto"})},
            false,
            "numerics.method",
            "whole molecules with chance, or smooth concentrations without; with \"auto\" rules "
            "decide"},
           {"initial",
            {concentration(), subtable("species_initial")},
            false,
            "\"0 M\"",
            "concentration at the start, everywhere or by material, or { expression = \"...\" }"}}};
}

Table species_initial_table() {
  return {"species_initial",
          "species.NAME.initial as a table",
          "Either an expression, or a concentration for each material named: `{ medium = \"1 nM\", gel = \"5 nM\" }`.",
          {{"expression",
            {expression("a formula for the concentration")},
            false,
            "",
            "concentration as a formula of x, y, z and the parameters"},
           {"NAME", {concentration()}, false, "", "concentration in the material of this name"}}};
}

Table initial_table() {
  return {"initial",
          "[[initial]]",
          "An initial amount; just one of `concentration`, `count` and `expression` is given.",
          {{"species", one_or_more(a_species), true, "", "which species"},
           {"material", {text(a_material)}, false, "all in which it lives", "only in this material"},
           {"concentration", {concentration()}, false, "", "amount per volume"},
           {"count",
            {quantity(dimensions::amount, {0, 9007199254740992.0, false, true})},
            false,
            "",
            "molecules in all, spread evenly"},
           {"expression",
            {expression("a formula for the concentration")},
            false,
            "",
            "concentration as a formula of x, y, z and the parameters"}},
          ShapeUse::optional};
}

Table reaction_table() {
  return {"reaction",
          "[[reaction]]",
          "A reaction runs at v = k prod C^nu events per volume and time, where C are the concentrations of the "
          "reactants and nu "
          "their counts in the equation.",
          {{"equation",
            {text("an equation, such as \"A + B <-> C\"")},
            true,
            "",
            "reactants -> products or, both ways, reactants <-> products; `2 A` for two, `0` for nothing"},
           {"forward",
            {unit_later("a rate constant with its unit", not_negative)},
            false,
            "",
            "rate constant k from left to right; its unit follows from the number of reactants"},
           {"backward",
            {unit_later("a rate constant with its unit", not_negative)},
            false,
            "",
            "rate constant k from right to left, where the equation has <->"},
           {"rate",
            {expression("a formula for v")},
            false,
            "",
            "instead of `forward`: v as a formula of species, parameters, x, y, z and t, where the equation has ->"},
           {"in", one_or_more(a_material), false, "wherever all its species live", "materials in which it runs"},
           {"name", {text("any text")}, false, "the equation", "what reports call it"}}};
}

Table boundary_table() {
  return {"boundary",
          "[[boundary]]",
          "What species do at a side of the domain or at the surface of a material. A fixed concentration is a "
          "reservoir that "
          "molecules enter and leave; an absorbing one holds none.",
          {{"species", one_or_more(a_species), true, "", "which species"},
           {"at", one_or_more("\"x_min\", \"x_max\", ... or the name of a material"), true, "", "where"},
           {"type", {choice({"fixed", "flux", "absorb", "reflect"})}, true, "", "what happens there"},
           {"value",
            {unit_later("a concentration or a flux", not_negative)},
            false,
            "",
            "fixed: the concentration; flux: molecules per area and time into the domain"}}};
}

}  // namespace

std::vector<Table> chemistry_tables() {
  return {species_table(), species_initial_table(), initial_table(), reaction_table(), boundary_table()};
}

}  // namespace shmoo::scene
