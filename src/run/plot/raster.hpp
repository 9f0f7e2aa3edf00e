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

inline constexpr Colour grey_of_walls{0xc9, 0xc4, 0xbc}, grey_of_others{0xec, 0xea, 0xe6};

// Three bytes a pixel: viridis of the particle's value in the range; where that is NaN, the particle's grey; white
// where no particle is near.
std::string coloured(const std::vector<std::int32_t>& pixels, const std::vector<double>& values, const Range& range,
                     const std::vector<Colour>& greys);

}  // namespace shmoo::run
