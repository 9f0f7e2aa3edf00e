#include "rdme/propensity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace shmoo::rdme {

Propensities::Propensities(const Network& network) : network_(network), species_(network.species()) {
  for (const Reaction& reaction : network.reactions()) {
    Law law;
    law.constant = reaction.rate_constant;
    law.order = reaction.order;
    law.first = static_cast<std::uint32_t>(factors_.size());
    for (const scene::Term& term : reaction.reactants) {
      int taken = 0;
      for (const Change& change : reaction.changes) {
        if (change.species == term.species) taken = std::max(0, -change.amount);
      }
      factors_.push_back({term.species, term.count, network.stochastic(term.species), taken});
    }
    law.last = static_cast<std::uint32_t>(factors_.size());
    if (!reaction.expression.empty() && reaction.stochastic) {
      law.expression = static_cast<int>(expressions_.size());
      expressions_.emplace_back(reaction.expression, expression_names(network));
    }
    laws_.push_back(law);
  }
}

void Propensities::bind(const Voxels& voxels, const State& state) {
  voxels_ = &voxels;
  count_ = state.count.data();
  amount_ = state.amount.data();
  volume_ = voxels.volume.data();
  inverse_volume_.resize(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) inverse_volume_[i] = 1.0 / voxels.volume[i];
}

void Propensities::set_time(double t) {
  time_ = t;
  for (Expression& expression : expressions_) expression.set_time(t);
}

double Propensities::evaluate(int reaction, std::size_t voxel) {
  const Law& law = laws_[reaction];
  if (available(law, voxel) == 0.0) return 0.0;
  Expression& expression = expressions_[law.expression];
  for (int species : expression.reads()) {
    const std::size_t at = voxel * species_ + species;
    const double n = network_.stochastic(species) ? static_cast<double>(count_[at]) : std::max(0.0, amount_[at]);
    expression.set_concentration(species, n * inverse_volume_[voxel]);
  }
  const auto& x = voxels_->position[voxel];
  expression.set_position(x[0], x[1], x[2]);
  const double a = volume_[voxel] * expression.value();
  if (!(a >= 0.0 && a <= 1e300)) refuse(reaction, voxel, a);
  return a;
}

void Propensities::refuse(int reaction, std::size_t voxel, double value) const {
  throw base::RunError(
      fmt::format("reaction {} has the propensity {} 1/s in voxel {} at t = {} s; it must be a finite number "
                  ">= 0: look at its rate law and at the numbers it reads",
                  network_.reactions()[reaction].name, value, voxel, time_));
}

}  // namespace shmoo::rdme
