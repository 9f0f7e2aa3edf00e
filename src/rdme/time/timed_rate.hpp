#pragma once
// A rate law that contains t, with what is needed to sample it exactly: its value at any time, times at which it jumps
// (to the last bit), and a bound over a stretch of time.
//
// Jumps are found where a comparison or a rounding in the formula changes, not where the rate happens to be looked at,
// so that a pulse of any width counts. Between jumps a law is taken as smooth, and the bound is its largest value at
// nine times plus twice the largest difference of neighbours.
#include <vector>

#include "rdme/expression.hpp"

namespace shmoo::rdme {

class TimedRate {
 public:
  TimedRate(const std::string& text, const ExpressionNames& names);

  // Calls set(expression) for each formula: it sets what they read besides the time.
  template <class Set>
  void prepare(const Set& set) {
    set(rate_);
    for (Step& step : local_) prepare(step, set);
    for (Step& step : common_) prepare(step, set);
  }

  double at(double t) {
    rate_.set_time(t);
    return rate_.value();
  }
  double time() const { return rate_.time(); }  // of the last value

  // Not below the rate at any time in [from, to], which holds no common step. Where the rate is negative or no finite
  // number at a time that is looked at: that value.
  double bound(double from, double to);

  // Adds the first moment behind each step that is the same everywhere and for all amounts.
  void common_steps(double from, double to, std::vector<double>& moments) { find(common_, from, to, moments); }
  // Adds the first moment behind every other step, at the amounts that are set.
  void local_steps(double from, double to, std::vector<double>& moments) { find(local_, from, to, moments); }

 private:
  struct Step {
    Expression level, distance;
  };
  template <class Set>
  static void prepare(Step& step, const Set& set) {
    set(step.level);
    set(step.distance);
  }
  static void find(std::vector<Step>& steps, double from, double to, std::vector<double>& moments);
  static void find(Step& step, double from, double to, int depth, std::vector<double>& moments);
  double smooth_bound(double from, double to);

  Expression rate_;
  std::vector<Step> local_, common_;  // local: reads amounts or places, too
};

}  // namespace shmoo::rdme
