#pragma once
// An experiment without particles: all of the scene is one well, mixed at all times. What a realisation needs is kept
// for the next one, so that a realisation costs its events and little else.
#include <memory>

#include "coupling/experiment.hpp"
#include "coupling/rules/judgement.hpp"

namespace shmoo::coupling {

std::unique_ptr<Experiment> make_well_mixed(Judgement judgement);

}  // namespace shmoo::coupling
