#include "rdme/propensity.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"

namespace shmoo::rdme {

Propensities::Propensities(const Network& network)
    : network_(network), laws_(network, true), species_(network.species()) {}

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
  for (Expression& expression : laws_.expressions) expression.set_time(t);
}

double Propensities::evaluate(int reaction, std::size_t voxel) {
  const Law& law = laws_.of_reaction[reaction];
  if (available(law, voxel) == 0.0) return 0.0;
  Expression& expression = laws_.expressions[law.expression];
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
