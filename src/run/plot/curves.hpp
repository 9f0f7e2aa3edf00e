#pragma once
// Curves with their spread.
#include <filesystem>
#include <string>
#include <vector>

#include "run/result_file.hpp"

namespace shmoo::run {

struct Curve {
  std::string heading, title, x_label, name, unit;  // the y axis is NAME in UNIT
  std::vector<double> x;                            // ascending, in the label's unit
  Slice y;                                          // statistics at each x
  std::vector<double> probabilities;                // of y.quantiles
  std::vector<std::vector<double>> examples;        // single realisations
  bool points = false;                              // dots on the mean
};

void draw_curve(const Curve& curve, const std::filesystem::path& png);

}  // namespace shmoo::run
