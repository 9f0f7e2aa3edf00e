// The schema of zones of a finer spacing.
#include "scene/forms.hpp"
#include "scene/tables.hpp"

namespace shmoo::scene {

using namespace forms;

std::vector<Table> refinement_tables() {
  return {{"refinement",
           "[[refinement]]",
           "A box in which the particles of a fluid, and of the walls in it, stand at half the distance. The kernel's "
           "reach halves with it, over the outermost coarse reach of the box. What passes into the box "
           "is split into four; what has left it is merged two by two. Flows of two dimensions without species, "
           "solids and thermal noise know it so far.",
           {{"spacing",
             {quantity(dimensions::length, positive)},
             true,
             "",
             "distance of neighbouring particles there: half of domain.spacing"}},
           ShapeUse::required}};
}

}  // namespace shmoo::scene
