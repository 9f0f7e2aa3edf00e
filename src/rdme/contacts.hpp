#pragma once
// Where the voxels of a habitat touch something outside it: clamped materials, surfaces that release a flux, sides.
#include "rdme/surroundings.hpp"

namespace shmoo::rdme {

// `graph` leads from home voxels to home and clamped ones; those to clamped ones become contacts.
template <int D>
HabitatGraph with_contacts(const Surroundings<D>& around, JumpGraph graph);

extern template HabitatGraph with_contacts(const Surroundings<1>&, JumpGraph);
extern template HabitatGraph with_contacts(const Surroundings<2>&, JumpGraph);
extern template HabitatGraph with_contacts(const Surroundings<3>&, JumpGraph);

}  // namespace shmoo::rdme
