#pragma once
// The error of one method at one level, and its parts.
#include "run/study/judge.hpp"

namespace shmoo::run::study {

// Errors are v - reference times a weight at each place.
struct Repeats {
  std::vector<const Sample*> samples{};  // of one method and level
  std::vector<double> reference{};       // at their places
  std::vector<double> weight{};          // 0 where the place does not count
  std::size_t realisations = 1;
};

// sqrt(mean e^2) and its like, over the places that count.
double norm_of(scene::StudyNorm norm, const std::vector<double>& errors, const std::vector<double>& weight);

std::vector<double> mean_over(const std::vector<const Sample*>& samples);

void fill_errors(const scene::StudyQuantity& quantity, const Repeats& repeats, Row& row);

// Statistical error of one ensemble: predicted, or measured where one realisation predicts none, or 0 where nothing
// varies.
double chance(const Row& row);

// Chance, and what is left of the error without it. `counterpart`: the means of the method whose solution this one's
// mean should be, at the same places, with their statistical error; empty for none.
struct Counterpart {
  std::vector<double> mean{};
  double statistical = 0;                       // of `mean`, weighted
  double error = unknown, error_seen_from = 0;  // of `mean` against the reference, without chance
};
void fill_statistics(const Repeats& repeats, const Counterpart& counterpart, Row& row);

}  // namespace shmoo::run::study
