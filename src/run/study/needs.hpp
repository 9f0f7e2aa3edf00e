#pragma once
// What an accuracy costs.
#include "run/study/judge.hpp"

namespace shmoo::run::study {

// Marks the rows to which no other is both cheaper and more accurate.
void mark_pareto(std::vector<Row>& rows);

// For each wanted accuracy and each method that reaches it: its cheapest level, and for a random method the number of
// realisations N with systematic^2 + predicted^2 n/N <= wanted^2 (n: those of the row), costing in proportion.
std::vector<Need> needs(const scene::Study& study, const std::vector<Row>& rows);

}  // namespace shmoo::run::study
