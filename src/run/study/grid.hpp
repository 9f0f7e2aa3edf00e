#pragma once
// From a study to its tasks.
#include <vector>

#include "run/study/point.hpp"

namespace shmoo::run::study {

// All runs of the study, in the order of methods, levels and repeats. Every model is read with its overrides first:
// throws base::InputError with the mistakes of all of them.
std::vector<Task> tasks_of(const scene::Study& study);

// A number of a study as one run sees it [SI]. base::InputError, at the number's place, where the model has none or one
// of another dimension.
double resolved(const scene::StudyNumber& number, const Task& task);

}  // namespace shmoo::run::study
