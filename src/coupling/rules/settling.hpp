#pragma once
// When a flow that starts at rest will be found steady: a forecast.
#include "coupling/rules/numbers.hpp"

namespace shmoo::coupling {

// [s]; infinite where the scene gives no numerics.steady_tolerance, has no walls or is not at rest at the start: then
// the flow may never be found steady.
double settling_time(const scene::Scene& scene, const Numbers& numbers);

// The longest interval [s] between two looks at the flow and at the species that it carries.
double flow_interval(const scene::Scene& scene, const Numbers& numbers);

}  // namespace shmoo::coupling
