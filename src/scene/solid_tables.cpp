// The schema of elastic solids: what a material of that type has.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

std::vector<Key> solid_keys() {
  return {
      {"young_modulus", {quantity(dimensions::pressure, positive)}, false, "", "of a solid, or"},
      {"shear_modulus", {quantity(dimensions::pressure, positive)}, false, "", "the shear modulus of a solid"},
      {"poisson_ratio",
       {number({-1, 0.5, true, true})},
       false,
       "",
       "of a solid; its bulk modulus is 2 G (1 + nu)/(3 (1 - 2 nu)), in plane strain too"},
      {"law",
       {choice({"neo-hookean", "saint-venant-kirchhoff", "hooke-jaumann"})},
       false,
       "\"neo-hookean\"",
       "elastic law of a solid; the first two work on the starting configuration, the last on the present one, with "
       "artificial stress and viscosity, as in the literature of updated-Lagrangian particles"},
      {"fixed",
       {subtable("part")},
       false,
       "nothing",
       "a shape; particles of a solid that start in it are held, or move as `velocity` and `angular_velocity` say"},
      {"initial_velocity",
       {per_axis({quantity(dimensions::speed, any), expression("a formula for a velocity")})},
       false,
       "at rest",
       "of a solid: one quantity or formula of x, y, z and the parameters per axis"},
      {"body_force",
       {per_axis({quantity(dimensions::acceleration, any)})},
       false,
       "none",
       "acceleration of a whole solid, such as its weight"},
      {"softening",
       {subtable("softening")},
       false,
       "none",
       "of a solid: its shear modulus falls with a species that lives in it"},
      {"growth", {subtable("growth")}, false, "none", "of a quasi-static wall, by a species"},
      {"artificial_stress",
       {number({0, 1})},
       false,
       "0.2",
       "of a solid with law \"hooke-jaumann\": repulsion in tension (Gray, Monaghan & Swift 2001)"},
      {"artificial_viscosity",
       {number({0, 10})},
       false,
       "1",
       "of a solid with law \"hooke-jaumann\": Monaghan's alpha; with artificial stress less than about 1 lets it clatter"}};
}

Table softening_table() {
  return {"softening",
          "materials.NAME.softening",
          "The shear modulus G0 max(least, 1 - coefficient C), C the concentration where the particle is now. The bulk "
          "modulus stays.",
          {{"species", {text("the name of a species")}, true, "", "what softens"},
           {"coefficient",
            {quantity(base::power(dimensions::concentration, -1), not_negative)},
            true,
            "",
            "such as \"0.99 m^3/mol\""},
           {"least", {number({0, 1, true, false})}, false, "0.01", "what is left of G0 at most softened"}}};
}

}  // namespace shmoo::scene
