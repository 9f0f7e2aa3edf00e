// The schema of chemistry: species, their initial amounts, reactions, boundaries.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

constexpr std::string_view a_species = "the name of a species";
constexpr std::string_view a_material = "the name of a material";

Form concentration() { return quantity(dimensions::concentration, not_negative); }

Form molecules() { return quantity(dimensions::amount, {0, 9007199254740992.0, false, true}); }

Table species_table() {
  return {"species",
          "[species.NAME]",
          "A kind of molecule. Its name can be used in equations and expressions.",
          {{"in", one_or_more(a_material), false, "all materials that are not walls",
            "materials in which it lives; in a well-mixed scene its compartment, which may be left out where there is "
            "only one"},
           {"diffusivity",
            {quantity(dimensions::diffusivity, not_negative)},
            false,
            "\"0 m^2/s\"",
            "diffusion coefficient",
            Place::space},
           {"method",
            {choice({"stochastic", "langevin", "deterministic", "auto"})},
            false,
            "numerics.method",
            "whole molecules with chance, or smooth concentrations without; with \"auto\" rules "
            "decide"},
           {"initial",
            {concentration(), molecules(), subtable("species_initial")},
            false,
            "\"0 M\"",
            "concentration or molecules in all at the start, or the concentration by material, or { expression = "
            "\"...\" }"}}};
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
           {"material", {text(a_material)}, false, "all in which it lives", "only in this material", Place::space},
           {"concentration", {concentration()}, false, "", "amount per volume"},
           {"count", {molecules()}, false, "", "molecules in all, spread evenly"},
           {"expression",
            {expression("a formula for the concentration")},
            false,
            "",
            "concentration as a formula of x, y, z and the parameters"}},
          ShapeUse::optional};
}

Table reaction_table() {
  return {
      "reaction",
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
       {"propensity",
        {expression("a formula for events per second")},
        false,
        "",
        "instead of `forward` or `rate`: events per second as a formula of pure numbers, in which species stand for "
        "their numbers of molecules and parameters for their values in SI units; no units are checked",
        Place::well},
       {"in", one_or_more(a_material), false, "wherever all its species live", "materials in which it runs",
        Place::space},
       {"surface",
        {list({text(a_material)}, 2, 2)},
        false,
        "",
        "two materials: it runs where they touch, between a voxel of the first and its neighbours of the second. Each "
        "molecule of the first sees the mean concentration beside it; where the first has no reactant, `forward` is "
        "per contact area, such as \"1 um/s\"",
        Place::space},
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

Table compartment_table() {
  return {
      "compartment",
      "[compartments.NAME]",
      "A part of a well-mixed scene with a volume of its own; the concentration of a species is its number over the "
      "volume of its compartment.",
      {{"volume", {quantity(dimensions::volume, positive)}, true, "", "its volume"}}};
}

Table event_table() {
  const Form formula = expression("a formula");
  return {
      "event",
      "[[event]]",
      "When its trigger turns from false to true, and `delay` later, what it sets is set at once. Its formulas are of "
      "pure numbers, as `propensity` is. A record at the time of an event shows what is after it.",
      {{"name", {text("any text")}, false, "its number", "what messages call it"},
       {"at", {quantity(dimensions::time, any)}, false, "", "the time at which it happens, or"},
       {"trigger", {formula}, false, "", "a condition, such as \"X > 100 && t >= 20\""},
       {"delay", {quantity(dimensions::time, not_negative), formula}, false, "\"0 s\"", "from trigger to event [s]"},
       {"priority",
        {formula, number(any)},
        false,
        "0",
        "of events at one time the largest goes first; equal ones go in the order of the file"},
       {"initially",
        {boolean()},
        false,
        "true",
        "what the trigger counts as before the start: an event whose trigger is true at the start happens there only "
        "where this is false"},
       {"persistent",
        {boolean()},
        false,
        "true",
        "it happens even where the trigger turns false before the delay is over"},
       {"values",
        {choice({"trigger", "event"})},
        false,
        "\"trigger\"",
        "the moment whose numbers the formulas of `set` read, where there is a delay or another event goes first"},
       {"set",
        {named({unit_later("a quantity"), formula, number(any)}, "the name of a species or parameter")},
        true,
        "",
        "new numbers of molecules of species, and values of parameters (a quantity, or SI)"}}};
}

}  // namespace

std::vector<Table> chemistry_tables() {
  return {compartment_table(), species_table(), species_initial_table(), initial_table(), reaction_table(),
          boundary_table(),    event_table()};
}

}  // namespace shmoo::scene
