#pragma once
// Pictures are drawn by gnuplot, called as a child process on files in a folder of its own; no shell takes part.
#include <filesystem>
#include <string>
#include <vector>

#include "run/scratch_folder.hpp"

namespace shmoo::run {

class Gnuplot {
 public:
  // A table of numbers, columns of equal length; NaN leaves a gap. The script reads it as 'NAME'.
  void table(const std::string& name, const std::vector<std::vector<double>>& columns) const;
  void bytes(const std::string& name, const std::string& data) const;

  // Draws the script on a canvas of width x height [pixels] into `png`. base::RunError where gnuplot is missing or
  // complains.
  void draw(const std::string& script, int width, int height, const std::filesystem::path& png) const;

 private:
  ScratchFolder folder_{"shmoo-plot"};
};

// Any text as a gnuplot string between single quotes, in which nothing is substituted: a quote becomes a typographic
// one, control characters become spaces.
std::string quoted(const std::string& text);

}  // namespace shmoo::run
