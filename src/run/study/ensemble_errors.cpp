#include "run/study/ensemble_errors.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::run::study {
namespace {

using Values = std::vector<double>;

double square(double x) { return x * x; }

double rms(const Values& errors, const Values& weight) { return norm_of(scene::StudyNorm::rms, errors, weight); }

Values difference(const Values& a, const Values& b) {
  Values all(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) all[i] = a[i] - b[i];
  return all;
}

std::size_t counting(const Values& weight) {
  return weight.size() - std::size_t(std::count(weight.begin(), weight.end(), 0.0));
}

// sqrt(variance/N), in the root mean square over places and repeats.
double predicted(const Repeats& repeats) {
  double sum = 0.0;
  for (const auto* sample : repeats.samples) {
    if (sample->variance.empty()) return unknown;
    for (std::size_t i = 0; i < sample->size(); ++i)
      sum += square(repeats.weight[i]) * sample->variance[i] / double(repeats.realisations);
  }
  return std::sqrt(sum / double(repeats.samples.size() * counting(repeats.weight)));
}

// The standard deviation between ensembles with seeds of their own, in the root mean square over places.
double measured(const Repeats& repeats, const Values& mean) {
  const auto n = repeats.samples.size();
  if (n < 2) return unknown;
  double sum = 0.0;
  for (const auto* sample : repeats.samples)
    for (std::size_t i = 0; i < mean.size(); ++i)
      sum += square(repeats.weight[i] * (sample->value[i] - mean[i])) / double(n - 1);
  return std::sqrt(sum / double(counting(repeats.weight)));
}

}  // namespace

double norm_of(scene::StudyNorm norm, const Values& errors, const Values& weight) {
  double sum = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    sum += square(weight[i] * errors[i]);
    largest = std::max(largest, std::abs(weight[i] * errors[i]));
  }
  const auto n = double(counting(weight));
  switch (norm) {
    case scene::StudyNorm::rms:
      return std::sqrt(sum / n);
    case scene::StudyNorm::root_sum_over_n:
      return std::sqrt(sum) / n;
    case scene::StudyNorm::maximum:
      return largest;
  }
  return largest;
}

Values mean_over(const std::vector<const Sample*>& samples) {
  Values mean(samples.front()->size(), 0.0);
  for (const auto* sample : samples)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += sample->value[i] / double(samples.size());
  return mean;
}

void fill_errors(const scene::StudyQuantity& quantity, const Repeats& repeats, Row& row) {
  Values each;
  double squares = 0.0, published_squares = 0.0;
  const auto n = double(repeats.samples.size());
  for (const auto* sample : repeats.samples) {
    const auto errors = difference(sample->value, repeats.reference);
    each.push_back(norm_of(quantity.norm, errors, repeats.weight));
    squares += square(each.back()) / n;
    published_squares += square(norm_of(quantity.published_norm, errors, repeats.weight)) / n;
  }
  row.error = std::sqrt(squares);
  row.ours = std::sqrt(published_squares);
  if (each.size() < 2) return;
  double mean = 0.0, deviation = 0.0;
  for (const double one : each) mean += one / n;
  for (const double one : each) deviation += square(one - mean) / (n - 1.0);
  row.spread = std::sqrt(deviation);
}

double chance(const Row& row) {
  return std::isfinite(row.predicted) ? row.predicted : std::isfinite(row.measured) ? row.measured : 0.0;
}

void fill_statistics(const Repeats& repeats, const Counterpart& counterpart, Row& row) {
  const auto mean = mean_over(repeats.samples);
  const auto n = double(repeats.samples.size());
  row.predicted = predicted(repeats);
  row.measured = measured(repeats, mean);
  const double noise = square(chance(row)) / n;  // of the mean over repeats, squared
  const double error = rms(difference(mean, repeats.reference), repeats.weight);
  row.systematic = std::sqrt(std::max(0.0, square(error) - noise));
  // The mean square of pure noise over p places scatters by sqrt(2/p) of itself; four times that is seen.
  const double seen = 4.0 * std::sqrt(2.0 / double(counting(repeats.weight)));
  row.systematic_seen_from = std::sqrt(noise * seen);
  if (counterpart.mean.empty()) return;
  const double both = noise + square(counterpart.statistical);
  const double apart = square(rms(difference(mean, counterpart.mean), repeats.weight));
  row.bias_seen_from = std::sqrt(both * seen);
  row.bias = std::sqrt(std::max(0.0, apart - both));
  if (row.bias > row.bias_seen_from) return;
  row.systematic = counterpart.error;
  row.systematic_seen_from = counterpart.error_seen_from;
}

}  // namespace shmoo::run::study
