#pragma once
// From points to what a study says: errors, orders, costs, and for random methods what part of the error is chance.
#include <optional>
#include <string>
#include <vector>

#include "run/study/point.hpp"

namespace shmoo::run::study {

// One method at one level, over its repeats. Errors are in the quantity's norm and scale; `unknown` where there is
// none.
struct Row {
  std::string method, level{};
  bool random = false;
  std::size_t repeats = 1, realisations = 1;
  double resolution = unknown;
  double error = unknown, spread = unknown;    // root mean square over repeats; their standard deviation
  double order = unknown;                      // from the level before
  double ours = unknown, published = unknown;  // in the norm of the published figure
  double cpu_seconds = unknown;                // of one ensemble, mean over repeats
  double cpu_per_realisation = unknown, steps = unknown, events = unknown, memory = unknown;
  // Random methods, always in the root mean square.
  double predicted = unknown, measured = unknown;  // statistical error of one ensemble: sqrt(variance/N); from repeats
  std::string mean_of{};                           // the method that its mean should agree with
  double bias = unknown,
         bias_seen_from = unknown;        // of the mean against `mean_of`, and the least that chance would hide
  double systematic_seen_from = unknown;  // the least that chance would hide
  double systematic = unknown;            // what no number of realisations removes
  std::string failure{};                  // why a run of it failed
  bool pareto = false;                    // no other row is both cheaper and more accurate
};

// The cheapest way to an accuracy; no method where there is none.
struct Need {
  double wanted = 0, cpu_seconds = unknown;
  std::string method, level{};
  std::size_t realisations = 1;
  bool random = false;
};

struct Verdict {
  std::string quantity, norm{};
  std::vector<Row> rows{};
  std::vector<Need> needs{};  // for each wanted accuracy and method
};

// base::InputError where a reference does not fit the study, such as a table that does not cover it.
std::vector<Verdict> judge(const scene::Study& study, const std::vector<Task>& tasks, const std::vector<Point>& points);

}  // namespace shmoo::run::study
