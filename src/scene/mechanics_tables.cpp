// The schema of mechanics: how solids move, and what species do to them.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

namespace {

const Dimension per_concentration = base::power(dimensions::concentration, -1);

Table mechanics_table() {
  return {
      "mechanics",
      "[mechanics]",
      "How solids move. Dynamic motion resolves every wave in time. Quasi-static motion is for a closed wall under "
      "turgor, a ring round the x axis: a sequence of equilibria while species soften it and make it grow, by steps "
      "of seconds.",
      {{"motion", {choice({"dynamic", "quasi-static"})}, false, "\"dynamic\"", "every wave, or equilibria"},
       {"turgor", {quantity(dimensions::pressure, positive)}, false, "", "quasi-static: pressure in the cavity"},
       {"step",
        {quantity(dimensions::time, positive)},
        false,
        "by error control",
        "quasi-static: time from equilibrium to equilibrium; absent: as long as `tolerance` allows, or 2 `tolerance` x "
        "run.until where species are random"},
       {"tolerance",
        {number({1e-6, 0.1})},
        false,
        "1e-3",
        "quasi-static: error of the wall's length that steps may cost it, over its length, where `step` is absent"},
       {"columns",
        {integer(8, 100000)},
        false,
        "twice as many as domain.spacing asks",
        "quasi-static: particles along half of the wall's outline; a wall that grows spreads them"},
       {"source", {list({subtable("source")})}, false, "[]", "quasi-static: where species enter the wall"}}};
}

Table source_table() {
  return {"source",
          "[[mechanics.source]]",
          "A species enters the wall around its tip, its end on the axis that is farthest along x, through all its "
          "thickness: dC/dt = rate w(s) (concentration - C), w = exp(-(s/width)^2), s the arc length from the tip.",
          {{"species", {text("the name of a species")}, true, "", "what enters"},
           {"rate", {quantity(dimensions::frequency, positive)}, true, "", "how fast at the tip"},
           {"concentration", {quantity(dimensions::concentration, positive)}, true, "", "what it tends to at the tip"},
           {"width", {quantity(dimensions::length, positive)}, true, "", "of the place where it enters"}}};
}

Table growth_table() {
  return {"growth",
          "growth of a solid",
          "Material is inserted in both directions of the wall at the rate coefficient C max(0, tension - "
          "yield_stress), the "
          "tension being the mean of those along and round the wall.",
          {{"species", {text("the name of a species")}, true, "", "what makes it grow"},
           {"coefficient",
            {quantity(per_concentration / (dimensions::pressure * dimensions::time), positive)},
            true,
            "",
            "such as \"0.1 m^3/(mol MPa s)\""},
           {"yield_stress",
            {quantity(dimensions::pressure, not_negative)},
            false,
            "\"0 Pa\"",
            "below which nothing grows"}}};
}

}  // namespace

std::vector<Table> mechanics_tables() { return {mechanics_table(), source_table(), growth_table()}; }

}  // namespace shmoo::scene
