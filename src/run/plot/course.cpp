// A field of a well-mixed result: its course over time.
#include "run/plot/curves.hpp"
#include "run/plot/plot.hpp"

namespace shmoo::run {

void plot_course(const ResultFile& result, const Entry& field, const std::filesystem::path& png) {
  const auto reading = readable("s", largest_magnitude(result.times));
  Curve curve;
  curve.heading = result.title;
  curve.title = field.name + ", " + ensemble_text(result, field);
  curve.x_label = with_unit("time", reading.unit);
  curve.name = field.name;
  curve.unit = field.unit;
  curve.x = scaled(result.times, reading.factor);
  curve.probabilities = field.probabilities;
  for (std::size_t time = 0; time < result.times.size(); ++time) {
    const auto slice = result.field_slice(field, time);
    curve.y.mean.push_back(slice.mean[0]);
    if (!slice.error.empty()) curve.y.error.push_back(slice.error[0]);
    curve.y.quantiles.resize(slice.quantiles.size());
    for (std::size_t q = 0; q < slice.quantiles.size(); ++q) curve.y.quantiles[q].push_back(slice.quantiles[q][0]);
  }
  draw_curve(curve, png);
}

}  // namespace shmoo::run
