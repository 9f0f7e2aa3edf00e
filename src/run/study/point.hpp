#pragma once
// The grid of a study: a task is one run of the model, a point what came of it.
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "scene/study.hpp"

namespace shmoo::run::study {

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

struct Task {
  std::size_t method = 0, level = 0, repeat = 0;
  scene::Overrides overrides{};
  std::uint64_t seed = 0;
  std::size_t realisations = 1;
  int dimension = 0;
  bool random = false;       // realisations differ
  double work = 0;           // a guess, to begin with the cheap ones: particles times realisations
  std::string model_text{};  // overrides applied
  std::string name{};        // of its files
  std::string key{};         // SHA-256 of all that its point depends on
};

// One quantity of one run: values at places and times, with the variance of a single realisation where they vary.
struct Sample {
  std::vector<double> x, y, z, t{};  // [m], [s]
  std::vector<double> value{};       // SI, mean over the realisations
  std::vector<double> variance{};    // empty where nothing varies or one realisation was run
  std::size_t size() const { return value.size(); }
};

struct Point {
  std::string failure{};                     // why there are no samples; empty: all is well
  double cpu_seconds = 0, wall_seconds = 0;  // of the whole process
  double memory = 0;                         // largest resident size [bytes]
  double cpu_per_realisation = 0;            // [s]
  double steps = unknown, events = unknown;  // time steps of the flow or intervals of chemistry; per realisation
  double resolution = unknown;               // what the study calls so
  std::string revision{}, command{};
  std::vector<Sample> samples{};  // [quantity]
};

}  // namespace shmoo::run::study
