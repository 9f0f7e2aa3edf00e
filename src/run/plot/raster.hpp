#pragma once
// Particles as a picture: every pixel takes the colour of the particle nearest to it, so that particles tile the plane
// however they lie.
#include <cstdint>
#include <string>
#include <vector>

#include "run/plot/style.hpp"

namespace shmoo::run {

struct Window {
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
};

// The index of the nearest particle of each pixel, row by row from the lower left; -1 farther than `reach` from all.
// `points` holds x, y in turn; all lengths in one unit.
std::vector<std::int32_t> nearest_particles(const std::vector<double>& points, const Window& window, int width,
                                            int height, double reach);

// Three bytes a pixel: viridis of the value in the range, `absent` grey for NaN, white where no particle is near.
std::string coloured(const std::vector<std::int32_t>& pixels, const std::vector<double>& values, const Range& range);

}  // namespace shmoo::run
