#pragma once
// Means and variances over realisations, entry by entry, for tests; and what an exact law of means is judged by.
#include <cmath>
#include <cstddef>
#include <ctime>
#include <vector>

namespace shmoo::test {

class Moments {
 public:
  void add(const std::vector<double>& x) {
    if (sum_.empty()) {
      first_ = x;
      sum_.assign(x.size(), 0.0);
      sum2_.assign(x.size(), 0.0);
    }
    ++n_;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double d = x[i] - first_[i];  // shifted, against cancellation
      sum_[i] += d;
      sum2_[i] += d * d;
    }
  }
  std::size_t size() const { return sum_.size(); }
  double mean(std::size_t i) const { return first_[i] + sum_[i] / double(n_); }
  double variance(std::size_t i) const {
    return n_ < 2 ? 0.0 : (sum2_[i] - sum_[i] * sum_[i] / double(n_)) / double(n_ - 1);
  }
  double standard_error(std::size_t i) const { return std::sqrt(variance(i) / double(n_)); }

 private:
  std::size_t n_ = 0;
  std::vector<double> first_, sum_, sum2_;
};

// CPU seconds of this process, all threads.
inline double cpu_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace shmoo::test
