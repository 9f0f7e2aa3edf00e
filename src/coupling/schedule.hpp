#pragma once
// When to record, and into which intervals the time between two records is split.
#include <cstddef>
#include <vector>

#include "scene/scene.hpp"

namespace shmoo::coupling {

// 0, every record_every, every record_at, and `until`; ascending, without duplicates. [s]
std::vector<double> record_times(const scene::Run& run);

// The end of the interval that begins at `t`: at most `step` further, never beyond `target`, and without a sliver: what
// is left to the target is divided evenly. [s]
double interval_end(double t, double step, double target);

}  // namespace shmoo::coupling
