#pragma once
// What a study prints, as tables in Markdown whose columns line up. Columns that say nothing are left out; a table
// without rows is the empty string.
#include <string>

#include "run/study/judge.hpp"

namespace shmoo::run::study {

std::string errors_table(const Verdict& verdict);      // every method at every level
std::string statistics_table(const Verdict& verdict);  // what part of the error of random methods is chance
std::string needs_table(const Verdict& verdict);       // what accuracies cost
std::string failures_text(const Verdict& verdict);     // one line per failure

// Root mean square of measured over predicted statistical error, over all rows that have both; unknown where none has.
double measured_over_predicted(const Verdict& verdict);

}  // namespace shmoo::run::study
