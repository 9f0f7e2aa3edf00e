#include "coupling/rate_watch.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/splitting.hpp"
#include "rdme/network.hpp"
#include "rdme/sampler.hpp"

namespace shmoo::coupling {
namespace {

constexpr int samples = 16;
constexpr double most_mean_error = 1e-3, most_change = 0.1;  // of the largest rate
constexpr double few_events = 1e-2;
constexpr std::size_t most_places = 9;

}  // namespace

RateWatch::RateWatch(const scene::Scene& scene, const rdme::Network& network,
                     const std::vector<std::array<double, 3>>& places, double volume)
    : volume_(volume) {
  if (!network.sampled_rates_change_in_time() || rdme::samples_events(scene.numerics.sampler)) return;
  const auto concentration = reference_concentrations(scene);
  for (const auto& reaction : network.reactions()) {
    if (!reaction.stochastic || !reaction.reads_time) continue;
    auto& rate = rates_.emplace_back(reaction.expression, expression_names(network));
    for (const int species : rate.reads()) rate.set_concentration(species, concentration[std::size_t(species)]);
  }
  const std::size_t stride = std::max<std::size_t>(1, places.size() / most_places);
  for (std::size_t i = 0; i < places.size(); i += stride) places_.push_back(places[i]);
}

double RateWatch::latest(double t, double end) {
  for (auto& rate : rates_) {
    for (const auto& place : places_) end = cut(rate, place, t, end);
  }
  return end;
}

double RateWatch::cut(rdme::Expression& rate, const std::array<double, 3>& place, double t, double end) const {
  const double largest = look(rate, place, t, end).largest;
  for (;;) {
    const Range range = look(rate, place, t, end);
    const bool changes = range.mean_error > most_mean_error * largest || range.change > most_change * largest;
    const double half = t + 0.5 * (end - t);
    if (!changes || range.largest * volume_ * (end - t) < few_events || !(half > t && half < end)) return end;
    end = half;
  }
}

RateWatch::Range RateWatch::look(rdme::Expression& rate, const std::array<double, 3>& place, double t,
                                 double end) const {
  rate.set_position(place[0], place[1], place[2]);
  const auto at = [&](double time) {
    rate.set_time(time);
    return rate.value();
  };
  const double middle = at(t + 0.5 * (end - t));
  Range range{std::abs(middle), 0.0, 0.0};
  double sum = 0.0;
  for (int k = 0; k <= samples; ++k) {  // the mean by the trapezoidal rule
    const double value = at(t + (end - t) * k / samples);
    sum += k == 0 || k == samples ? 0.5 * value : value;
    range.largest = std::max(range.largest, std::abs(value));
    range.change = std::max(range.change, std::abs(value - middle));
  }
  range.mean_error = std::abs(sum / samples - middle);
  return range;
}

}  // namespace shmoo::coupling
