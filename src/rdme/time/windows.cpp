// The windows in which rates that contain t are bounded (propensity.hpp).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "rdme/propensity.hpp"

namespace shmoo::rdme {
namespace {

constexpr std::size_t most_voxels = 5;  // that are looked at, for each reaction
constexpr int looks = 16;               // besides those that make the bound
constexpr double golden = 0.6180339887498949;
constexpr double allowed_waste = 4;  // events drawn in vain in a voxel that cost as much as another window
constexpr double round_off = 1e-12;
constexpr int deepest = 40;                    // halvings
constexpr std::size_t most_windows = 1000000;  // of one step

}  // namespace

const std::vector<Window>& Propensities::windows(double t, double dt) {
  time_ = t;
  windows_.clear();
  laws_.set_parameters(network_, parameter_);
  if (laws_.timed.empty()) {
    windows_.push_back({0.0, dt});
    return windows_;
  }
  double from = t;
  const double to = t + dt;
  place_lookouts();
  std::vector<double> moments;
  for (TimedRate& rate : laws_.timed) rate.common_steps(from, to, moments);
  std::ranges::sort(moments);
  for (const double moment : moments) {
    if (!(moment > from && moment < to)) continue;
    split({from, std::nextafter(moment, from)}, 0);
    from = moment;
  }
  split({from, to}, 0);
  return windows_;
}

void Propensities::place_lookouts() {
  lookouts_.clear();
  for (std::size_t r = 0; r < laws_.of_reaction.size(); ++r) {
    if (laws_.of_reaction[r].timed < 0) continue;
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < voxels_->size(); ++i)
      if (network_.reactions()[r].in_material[voxels_->material[i]]) places.push_back(i);
    const std::size_t stride = std::max<std::size_t>(1, places.size() / most_voxels);
    for (std::size_t k = 0; k < places.size(); k += stride) lookouts_.push_back({int(r), places[k]});
  }
}

// At the numbers that are there now, and one where there is none: another molecule may come.
void Propensities::prepare(const Lookout& lookout) {
  laws_.timed[laws_.of_reaction[lookout.reaction].timed].prepare([&](Expression& formula) {
    for (const int species : formula.reads()) {
      const double n = std::max(1.0, number(lookout.voxel, species));
      formula.set_concentration(species, n * inverse_volume_[lookout.voxel]);
    }
    const auto& x = voxels_->position[lookout.voxel];
    formula.set_position(x[0], x[1], x[2]);
  });
}

void Propensities::split(const Window& window, int depth) {
  const double middle = window.from + 0.5 * (window.to - window.from);
  const bool divisible = depth < deepest && middle > window.from && middle < window.to;
  if (windows_.size() >= most_windows) {
    throw base::RunError(
        fmt::format("a rate that contains t changes more than {} times up to t = {} s, the end of a step; give a "
                    "numerics.splitting_step in which it changes less often",
                    most_windows, window.to));
  }
  if (!divisible || std::ranges::all_of(lookouts_, [&](const Lookout& one) { return calm(one, window); })) {
    windows_.push_back(window);
    return;
  }
  split({window.from, middle}, depth + 1);
  split({middle, window.to}, depth + 1);
}

// Is the bound a bound as far as one can see, and not far above the rate?
bool Propensities::calm(const Lookout& lookout, const Window& window) {
  TimedRate& rate = laws_.timed[laws_.of_reaction[lookout.reaction].timed];
  prepare(lookout);
  const double bound = rate.bound(window.from, window.to), length = window.to - window.from;
  if (!(bound >= 0.0 && std::isfinite(bound))) return true;  // where it is so, the sampler will say it
  double sum = 0.0;
  for (int k = 0; k < looks; ++k) {
    const double value = rate.at(window.from + length * std::fmod(0.5 + k * golden, 1.0));
    if (value > bound * (1 + round_off)) return false;
    sum += value;
  }
  return (bound - sum / looks) * volume_[lookout.voxel] * length <= allowed_waste;
}

}  // namespace shmoo::rdme
