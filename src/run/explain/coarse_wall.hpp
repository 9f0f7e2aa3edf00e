#pragma once
// How long a quasi-static wall takes. Where error control chooses its steps the first are a thousandth of the last, and
// where they are given the first find their equilibria with more pains: the pace of the part that was played says
// little. A coarse wall, though, takes much the same steps, and is gone through to the end in a second or two: what it
// needs after that part, over what it needs until there, tells the rest.
#include "run/explain/rehearsal.hpp"

namespace shmoo::run {

// CPU time after each step of a coarse wall, by fraction of the run; empty for other scenes, and walls that are coarse
// themselves. Steps that take more than `budget` seconds in all are not made, but taken to be like those before.
std::vector<Moment> coarse_course(const scene::Scene& scene, const Maker& make, double budget);

// [s] CPU time of all steps, from those that were played.
double by_coarse(const std::vector<Moment>& played, const std::vector<Moment>& coarse);

}  // namespace shmoo::run
