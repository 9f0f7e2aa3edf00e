// The schema of flow: inflow zones, what drives the fluid, effects.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

Table inflow_table() {
  return {"inflow",
          "[[inflow]]",
          "A sponge: inside the zone velocity and concentrations relax towards what is given.",
          {{"zone", {subtable("zone")}, true, "", "a box; an axis left out is covered whole"},
           {"velocity", {velocity()}, false, "left alone", "velocity of the fluid there"},
           {"species",
            {named({quantity(dimensions::concentration, not_negative)}, "the name of a species")},
            false,
            "left alone",
            "concentrations there, `{ A = \"10 nM\" }`"},
           {"relaxation_time", {quantity(dimensions::time, positive)}, false, "derived", "time that relaxation takes"},
           {"ramp_exponent",
            {integer(0, 10)},
            false,
            "0",
            "how strength rises from 0 to 1 along the flow: as this power of the way; 0: full strength everywhere"}}};
}

Table zone_table() {
  const Form pair = list({quantity(dimensions::length, any)}, 2, 2);
  std::vector<Key> keys;
  for (std::string_view axis : {"x", "y", "z"})
    keys.push_back({axis, {pair}, false, "the whole domain", "from and to"});
  return {"zone", "inflow.zone", "The extent of a zone on each axis.", std::move(keys)};
}

Table buoyancy_table() {
  return {"buoyancy",
          "[[buoyancy]]",
          "A species that makes the fluid lighter, in the approximation of Boussinesq: only its weight changes.",
          {{"species", {text("the name of a species")}, true, "", "which lives in the fluid"},
           {"expansion",
            {quantity(base::power(dimensions::concentration, -1), any)},
            true,
            "",
            "relative loss of weight per concentration, such as \"1e-3 m^3/molecule\"; negative: it makes heavier"},
           {"reference",
            {quantity(dimensions::concentration, any)},
            false,
            "\"0 molecules/m^3\"",
            "concentration at which nothing rises or sinks"}}};
}

Table flow_table() {
  return {"flow",
          "[flow]",
          "What drives the fluid, and the scales from which its time step follows.",
          {{"body_force",
            {per_axis({quantity(dimensions::acceleration, any)})},
            false,
            "none",
            "acceleration of the whole fluid"},
           {"initial_velocity",
            {per_axis({quantity(dimensions::speed, any), expression("a formula for a velocity")})},
            false,
            "at rest",
            "one quantity or formula of x, y, z and the parameters per axis"},
           {"gravity",
            {per_axis({quantity(dimensions::acceleration, any)})},
            false,
            "none",
            "of [[buoyancy]]; hydrostatic pressure is left out"},
           {"reference_speed", {quantity(dimensions::speed, positive)}, false, "derived", "largest speed to expect"},
           {"reference_length", {quantity(dimensions::length, positive)}, false, "derived", "width of the flow"},
           {"sound_speed",
            {quantity(dimensions::speed, positive)},
            false,
            "derived from the allowed density variation",
            "numerical speed of sound"},
           {"density_variation",
            {number({0, 0.1, true, false})},
            false,
            "0.01",
            "relative change of density that is allowed"},
           {"background_pressure",
            {quantity(dimensions::pressure, not_negative)},
            false,
            "\"0 Pa\"",
            "added to the pressure of the fluid; at least rho c0^2 where densities are summed beyond Mach 0.3"},
           {"temperature", {quantity(dimensions::temperature, positive)}, false, "", "for thermal noise, or"},
           {"thermal_energy", {quantity(dimensions::energy, positive)}, false, "", "kT itself"}}};
}

Table effects_table() {
  const auto effect = [](std::string_view name, std::string_view fallback, std::string_view doc) {
    return Key{name, {boolean(), choice({"auto"})}, false, fallback, doc};
  };
  return {
      "effects",
      "[effects]",
      "What is computed. An effect that is off costs nothing. All but `flow` need the flow. With \"auto\" rules decide "
      "from the numbers of the scene; `shmoo explain` tells which and why.",
      {{"default", {choice({"auto"})}, false, "as below", "\"auto\": for every effect that is not named here"},
       effect("flow", "true where something drives a fluid",
              "the fluid moves; driven by an inflow velocity, an open side, a body force, an initial velocity, a "
              "moving wall or "
              "thermal noise"),
       effect("viscosity", "true", "friction inside the fluid"),
       effect("density_diffusion", "true", "smooths the density"),
       effect("transport_velocity", "true without thermal noise", "shifts particles towards even spacing"),
       effect("bounce_back", "true where there are walls", "turns back what runs into a wall"),
       effect("closed_room", "true without open sides", "keeps the density that fills a room without open sides"),
       effect("thermal_noise", "false",
              "random forces of the heat bath; needs flow.temperature or flow.thermal_energy"),
       effect("species_advection", "true where there are species", "the flow carries species")}};
}

}  // namespace

std::vector<Table> flow_tables() {
  return {inflow_table(), zone_table(), buoyancy_table(), flow_table(), effects_table()};
}

}  // namespace shmoo::scene
