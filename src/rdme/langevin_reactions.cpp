#include "rdme/langevin_reactions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "rdme/samplers/share_groups.hpp"

namespace shmoo::rdme {

LangevinReactions::LangevinReactions(const Network& network) : network_(network), laws_(network, Treatment::langevin) {}

void LangevinReactions::bind(const Voxels& voxels, State& state) {
  voxels_ = &voxels;
  state_ = &state;
  rate_.assign(voxels.size() * network_.reactions().size(), 0.0);
  times_.assign(rate_.size(), 0.0);
}

double LangevinReactions::number(std::size_t voxel, int species) const {
  const std::size_t at = voxel * state_->species + species;
  return network_.stochastic(species) ? static_cast<double>(state_->count[at]) : std::max(0.0, state_->amount[at]);
}

// As of a sampled reaction: n (n - 1) ... of what fluctuates, powers of what is deterministic.
double LangevinReactions::rate(int reaction, std::size_t voxel) {
  const Law& law = laws_.of_reaction[reaction];
  const double volume = voxels_->volume[voxel];
  double a = law.constant * volume_factor(law.order, volume, 1.0 / volume);
  if (law.expression >= 0) {
    Expression& expression = laws_.expressions[law.expression];
    for (const int s : expression.reads()) expression.set_concentration(s, number(voxel, s) / volume);
    const auto& x = voxels_->position[voxel];
    expression.set_position(x[0], x[1], x[2]);
    expression.set_time(time_);
    a = volume * expression.value();
  } else {
    for (std::uint32_t f = law.first; f < law.last; ++f) {
      const Factor& factor = laws_.factors[f];
      const double n = number(voxel, factor.species), less = network_.deterministic(factor.species) ? 0.0 : 1.0;
      for (int k = 0; k < factor.count; ++k) a *= std::max(0.0, n - k * less);
    }
  }
  if (a >= 0.0 && a <= 1e300) return a;
  throw base::RunError(fmt::format(
      "reaction {} has the rate {} 1/s in voxel {} at t = {} s; it must be a finite number >= 0: look at its "
      "rate law and at the numbers it reads",
      network_.reactions()[reaction].name, a, voxel, time_));
}

void LangevinReactions::evaluate(double t) {
  time_ = t;
  laws_.set_parameters(network_, state_->parameter.data());
  const std::size_t stride = network_.reactions().size();
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (const int r : network_.langevin_in(voxels_->material[i])) rate_[i * stride + r] = rate(r, i);
  }
}

void LangevinReactions::evaluate_again(double t) {
  time_ = t;
  laws_.set_parameters(network_, state_->parameter.data());
  const std::size_t stride = network_.reactions().size();
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (const int r : network_.langevin_in(voxels_->material[i])) {
      double& a = rate_[i * stride + r];
      a = std::max(0.0, 2 * rate(r, i) - a);
    }
  }
}

double LangevinReactions::fastest() const {
  const std::size_t stride = network_.reactions().size();
  std::vector<double> flow(network_.species());  // [molecules/s]
  double fastest = 0;
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    std::fill(flow.begin(), flow.end(), 0.0);
    for (const int r : network_.langevin_in(voxels_->material[i])) {
      for (const Change& change : network_.reactions()[r].changes) {
        flow[change.species] += std::abs(change.amount) * rate_[i * stride + r];
      }
    }
    for (std::size_t s = 0; s < flow.size(); ++s) {
      if (flow[s] > 0) fastest = std::max(fastest, flow[s] / std::max(1.0, number(i, static_cast<int>(s))));
    }
  }
  return fastest;
}

void LangevinReactions::draw(double h, const StageAddress& address, std::span<double> taken) {
  const std::size_t stride = network_.reactions().size(), species = network_.species();
  share_groups(
      static_cast<std::uint32_t>(voxels_->size()), 1, [&](std::uint32_t begin, std::uint32_t end, std::size_t) {
        base::RandomSequence random(address.key, base::Stream::langevin_reactions, address.step, begin, address.stage);
        for (std::size_t i = begin; i < end; ++i) {
          for (const int r : network_.langevin_in(voxels_->material[i])) {
            const double times = times_[i * stride + r] = smooth_number(rate_[i * stride + r] * h, random);
            for (const Change& change : network_.reactions()[r].changes) {
              taken[i * species + change.species] += std::max(0.0, -change.amount * times);
            }
          }
        }
      });
}

void LangevinReactions::apply(std::span<const double> share) {
  const std::size_t stride = network_.reactions().size(), species = network_.species();
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (const int r : network_.langevin_in(voxels_->material[i])) {
      double times = times_[i * stride + r], least = 1;
      const auto& changes = network_.reactions()[r].changes;
      for (const Change& change : changes) {
        if (change.amount * times < 0) least = std::min(least, share[i * species + change.species]);
      }
      times *= least;
      for (const Change& change : changes) {
        const double molecules = change.amount * times;
        state_->amount[i * species + change.species] += molecules;
        Account<double>& account = state_->ledger.amounts[change.species];
        (molecules > 0 ? account.created : account.destroyed) += std::abs(molecules);
      }
    }
  }
}

}  // namespace shmoo::rdme
