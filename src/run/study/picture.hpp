#pragma once
// Work and precision: error against CPU time, both logarithmic, a line per method, the Pareto front marked.
#include <filesystem>

#include "run/study/judge.hpp"

namespace shmoo::run::study {

// Draws nothing and returns false where no method gave a finite error.
bool draw_work_precision(const std::string& title, const Verdict& verdict, const std::filesystem::path& png);

}  // namespace shmoo::run::study
