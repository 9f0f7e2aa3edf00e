#pragma once
// Statistics for tests of distributions. Each check is made at a fixed key, so a test that passes once passes always;
// the chance that a right program fails at a new key is stated by the threshold.
#include <gsl/gsl_cdf.h>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace shmoo::rdme {

inline constexpr double false_alarm = 1e-4;  // of one chi-square test
inline constexpr double errors_allowed = 4;  // standard errors: two-sided false-alarm rate 6e-5 of one test of a mean

struct Sample {
  double n = 0, sum = 0, squares = 0, fourth = 0;
  std::vector<double> values;
  void add(double x) {
    values.push_back(x);
    ++n;
    sum += x;
    squares += x * x;
  }
  double mean() const { return sum / n; }
  double variance() const { return (squares - sum * sum / n) / (n - 1); }
  double standard_error() const { return std::sqrt(variance() / n); }
  // Of the variance, from the fourth central moment.
  double variance_error() const {
    double m4 = 0;
    for (double x : values) m4 += std::pow(x - mean(), 4) / n;
    return std::sqrt((m4 - variance() * variance()) / n);
  }
};

inline double covariance(const Sample& x, const Sample& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.values.size(); ++i) sum += (x.values[i] - x.mean()) * (y.values[i] - y.mean());
  return sum / (x.n - 1);
}

// Pearson's test of observed numbers against expected ones; bins are joined from the left until each expects at
// least 5. Returns the probability of so large a misfit. `constraints`: 1 where the totals agree by construction.
inline double chi_square(const std::vector<double>& observed, const std::vector<double>& expected,
                         int constraints = 1) {
  double misfit = 0, seen = 0, hoped = 0;
  std::vector<std::pair<double, double>> bins;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    seen += observed[i];
    hoped += expected[i];
    if (hoped < 5) continue;
    bins.emplace_back(seen, hoped);
    seen = hoped = 0;
  }
  bins.back().first += seen;
  bins.back().second += hoped;
  for (const auto& [o, e] : bins) misfit += (o - e) * (o - e) / e;
  return gsl_cdf_chisq_Q(misfit, static_cast<double>(bins.size()) - constraints);
}

// Of whole numbers against probabilities of 0, 1, 2, ...; what is beyond the table is its last bin.
inline double chi_square(const Sample& sample, std::vector<double> probability) {
  double rest = 1;
  for (double p : probability) rest -= p;
  probability.push_back(std::max(0.0, rest));
  std::vector<double> observed(probability.size(), 0.0);
  for (double x : sample.values) ++observed[std::min(static_cast<std::size_t>(x), observed.size() - 1)];
  for (double& p : probability) p *= sample.n;
  return chi_square(observed, probability);
}

inline std::vector<double> poisson_law(double mean, int largest) {
  std::vector<double> p(largest + 1);
  for (int k = 0; k <= largest; ++k) p[k] = std::exp(k * std::log(mean) - mean - std::lgamma(k + 1.0));
  return p;
}

// Rows of a table under tests/data/rdme: column name -> values. Lines that begin with # are skipped.
inline std::map<std::string, std::vector<double>> read_table(const std::string& name) {
  std::ifstream file(std::string(SHMOO_SOURCE_DIR "/tests/data/rdme/") + name);
  if (!file) throw std::runtime_error("cannot open " + name);
  std::vector<std::string> columns;
  std::map<std::string, std::vector<double>> table;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    std::size_t k = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++k) {
      if (columns.size() <= k)
        columns.push_back(cell);
      else
        table[columns[k]].push_back(std::stod(cell));
    }
  }
  return table;
}

}  // namespace shmoo::rdme
