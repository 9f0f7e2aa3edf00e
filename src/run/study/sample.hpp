#pragma once
// Takes what a study compares out of a result file.
#include "run/result_file.hpp"
#include "run/study/point.hpp"

namespace shmoo::run::study {

// base::RunError where the result does not hold it.
Sample take(const ResultFile& result, const scene::StudyQuantity& quantity);

// Steps, events, cost and the resolution, from the same file.
void take_account(const ResultFile& result, const scene::Study& study, const Task& task, Point& point);

}  // namespace shmoo::run::study
