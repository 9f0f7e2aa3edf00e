#pragma once
// Values given on the command line, put into the document in place of what the file says.
#include <toml++/toml.h>

#include "scene/read.hpp"

namespace shmoo::scene {

// Paths are keys joined by dots ("run.seed"); a key with dots or blanks stands in double quotes; entries of a list are
// numbered from 0 ("region.0.diameter") or called by their `name`. A value that is not TOML is taken as text, so that
// quotes can be left out. Every value that is put in carries "--set PATH=VALUE" as the file of its source. Throws
// base::InputError with everything that is wrong.
void apply_overrides(toml::table& root, const Overrides& overrides);

}  // namespace shmoo::scene
