#pragma once
// An experiment of a wall that is in equilibrium at all times: chemistry in the wall, then softening and growth, then
// the next equilibrium, by steps of seconds.
#include <memory>

#include "coupling/experiment.hpp"
#include "coupling/rules/judgement.hpp"

namespace shmoo::coupling {

std::unique_ptr<Experiment> make_quasi_static(Judgement judgement);

}  // namespace shmoo::coupling
