#include "rdme/propensity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"

namespace shmoo::rdme {

Propensities::Propensities(const Network& network)
    : network_(network), laws_(network, Treatment::sampled), species_(network.species()) {
  for (const Law& law : laws_.of_reaction) quick_.push_back(make_quick(law));
}

Propensities::Quick Propensities::make_quick(const Law& law) const {
  Quick quick;
  quick.constant = law.constant;
  quick.applies = law.simple && law.order <= 2;
  int found = 0;
  for (std::uint32_t f = law.first; f < law.last && quick.applies; ++f) {
    const Factor& factor = laws_.factors[f];
    quick.applies = factor.stochastic;
    for (int k = 0; k < factor.count; ++k, ++found) {
      (found == 0 ? quick.first : quick.second) = factor.species;
      (found == 0 ? quick.first_scale : quick.second_scale) = 1;
      (found == 0 ? quick.first_shift : quick.second_shift) = -k;
    }
  }
  return quick;
}

void Propensities::bind_quick() {
  static constexpr double one = 1.0;
  for (std::size_t r = 0; r < quick_.size(); ++r) {
    const int order = laws_.of_reaction[r].order;
    quick_[r].stride = order == 1 ? 0 : 1;
    quick_[r].volume = order == 0 ? volume_ : order == 1 ? &one : inverse_volume_.data();
  }
}

void Propensities::bind(const Voxels& voxels, const State& state) {
  voxels_ = &voxels;
  count_ = state.count.data();
  amount_ = state.amount.data();
  volume_ = voxels.volume.data();
  parameter_ = state.parameter.data();
  inverse_volume_.resize(network_.any_sampled() ? voxels.size() : 0);
  for (std::size_t i = 0; i < inverse_volume_.size(); ++i) inverse_volume_[i] = 1.0 / voxels.volume[i];
  bind_quick();
  bind_surfaces();
}

void Propensities::set_time(double t) {
  time_ = t;
  window_ = {};
  for (Expression& expression : laws_.expressions) expression.set_time(t);
  laws_.set_parameters(network_, parameter_);
}

double Propensities::number(std::size_t voxel, int species) const {
  const std::size_t at = voxel * species_ + std::size_t(species);
  return network_.stochastic(species) ? static_cast<double>(count_[at]) : std::max(0.0, amount_[at]);
}

double Propensities::evaluate(int reaction, std::size_t voxel) {
  const Law& law = laws_.of_reaction[reaction];
  if (available(law, voxel) == 0.0) return 0.0;
  const auto load = [&](Expression& formula) {
    for (const int species : formula.reads())
      formula.set_concentration(species, number(voxel, species) * inverse_volume_[voxel]);
    const auto& x = voxels_->position[voxel];
    formula.set_position(x[0], x[1], x[2]);
  };
  double v = 0.0, t = time_;
  if (law.timed >= 0 && window_.to > window_.from) {
    TimedRate& rate = laws_.timed[law.timed];
    rate.prepare(load);
    v = rate.bound(window_.from, window_.to);
    t = rate.time();
  } else {
    Expression& expression = laws_.expressions[law.expression];
    load(expression);
    v = expression.value();
  }
  const double a = volume_[voxel] * v;
  if (!(a >= 0.0 && a <= 1e300)) refuse(reaction, voxel, a, t);
  return a;
}

bool Propensities::thin(int reaction, std::size_t voxel, double t, double rest, double bound) {
  const Law& law = laws_.of_reaction[reaction];
  if (available(law, voxel) == 0.0) return false;
  const Window window = std::exchange(window_, Window{});
  Expression& expression = laws_.expressions[law.expression];
  expression.set_time(std::clamp(t, window.from, window.to));
  time_ = t;
  const double a = evaluate(reaction, voxel);
  window_ = window;
  if (a <= bound * (1 + 1e-12)) return rest < a;
  throw base::RunError(fmt::format(
      "reaction {} has the propensity {} 1/s in voxel {} at t = {} s, above what was expected between {} and {} s ({} "
      "1/s): its rate law changes faster in time than it was looked at; give a numerics.splitting_step shorter than "
      "what it does there, or write a pulse as a comparison, like (t > a && t < b) ? high : low",
      network_.reactions()[reaction].name, a, voxel, t, window.from, window.to, bound));
}

void Propensities::refuse(int reaction, std::size_t voxel, double value, double t) const {
  throw base::RunError(
      fmt::format("reaction {} has the propensity {} 1/s in voxel {} at t = {} s; it must be a finite number "
                  ">= 0: look at its rate law and at the numbers it reads",
                  network_.reactions()[reaction].name, value, voxel, t));
}

}  // namespace shmoo::rdme
