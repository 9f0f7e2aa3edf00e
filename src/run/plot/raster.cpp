#include "run/plot/raster.hpp"

#include <algorithm>
#include <cmath>

namespace shmoo::run {
namespace {

constexpr Colour nothing{0xff, 0xff, 0xff};

// Particles sorted into square cells as wide as the reach.
class Cells {
 public:
  Cells(const std::vector<double>& points, const Window& window, double reach)
      : points_(points), window_(window), reach_(reach) {
    columns_ = static_cast<int>(std::ceil((window.x1 - window.x0) / reach)) + 2;
    rows_ = static_cast<int>(std::ceil((window.y1 - window.y0) / reach)) + 2;
    lists_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t i = 0; 2 * i < points.size(); ++i) {
      const int c = column(points[2 * i]), r = row(points[2 * i + 1]);
      if (c >= 0 && c < columns_ && r >= 0 && r < rows_) list(c, r).push_back(static_cast<std::int32_t>(i));
    }
  }

  std::int32_t nearest(double x, double y) const {
    double best = reach_ * reach_;
    std::int32_t found = -1;
    for (int r = std::max(0, row(y) - 1); r <= std::min(rows_ - 1, row(y) + 1); ++r) {
      for (int c = std::max(0, column(x) - 1); c <= std::min(columns_ - 1, column(x) + 1); ++c) {
        for (const auto i : lists_[static_cast<std::size_t>(r * columns_ + c)]) {
          const auto at = 2 * static_cast<std::size_t>(i);
          const double dx = points_[at] - x, dy = points_[at + 1] - y;
          if (dx * dx + dy * dy >= best) continue;
          best = dx * dx + dy * dy;
          found = i;
        }
      }
    }
    return found;
  }

 private:
  int column(double x) const {
    return static_cast<int>(std::floor(std::clamp((x - window_.x0) / reach_, -9.0, 1e6))) + 1;
  }
  int row(double y) const { return static_cast<int>(std::floor(std::clamp((y - window_.y0) / reach_, -9.0, 1e6))) + 1; }
  std::vector<std::int32_t>& list(int c, int r) { return lists_[static_cast<std::size_t>(r * columns_ + c)]; }

  const std::vector<double>& points_;
  Window window_;
  double reach_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<std::int32_t>> lists_;
};

}  // namespace

std::vector<std::int32_t> nearest_particles(const std::vector<double>& points, const Window& window, int width,
                                            int height, double reach) {
  const Cells cells(points, window, reach);
  std::vector<std::int32_t> pixels;
  pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int row = 0; row < height; ++row) {
    const double y = window.y0 + (row + 0.5) * (window.y1 - window.y0) / height;
    for (int column = 0; column < width; ++column)
      pixels.push_back(cells.nearest(window.x0 + (column + 0.5) * (window.x1 - window.x0) / width, y));
  }
  return pixels;
}

std::string coloured(const std::vector<std::int32_t>& pixels, const std::vector<double>& values, const Range& range,
                     const std::vector<Colour>& greys) {
  std::string bytes;
  bytes.reserve(3 * pixels.size());
  for (const auto pixel : pixels) {
    Colour colour = nothing;
    if (pixel >= 0) {
      const auto particle = static_cast<std::size_t>(pixel);
      const double value = values[particle];
      colour = std::isfinite(value) ? viridis((value - range.low) / (range.high - range.low)) : greys[particle];
    }
    for (const auto channel : colour) bytes += static_cast<char>(channel);
  }
  return bytes;
}

}  // namespace shmoo::run
