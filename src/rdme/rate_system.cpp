#include "rdme/rate_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace shmoo::rdme {

RateSystem::RateSystem(const Network& network)
    : network_(network), laws_(network, Treatment::integrated), place_of_(network.species(), -1) {
  for (int s = 0; s < static_cast<int>(network.species()); ++s) {
    if (!network.deterministic(s)) continue;
    place_of_[s] = static_cast<int>(species_.size());
    species_.push_back(s);
  }
  rows_.resize(species_.size());
}

void RateSystem::bind(const Voxels& voxels, const State& state) {
  voxels_ = &voxels;
  state_ = &state;
  for (std::size_t d = 0; d < species_.size(); ++d) {
    Row& row = rows_[d];
    const int g = voxels.graph_of_species[species_[d]];
    const double kappa = network_.diffusivity(species_[d]);
    row.graph = g < 0 ? nullptr : &voxels.graphs[g];
    if (row.graph && kappa == 0 && row.graph->flow.empty()) row.graph = nullptr;
    row.rate.resize(row.graph ? row.graph->target.size() : 0);
    for (std::size_t i = 0; row.graph && i < voxels.size(); ++i) {
      for (std::uint64_t p = row.graph->first[i]; p < row.graph->first[i + 1]; ++p) {
        row.rate[p] = jump_rate(*row.graph, p, kappa, voxels.volume[i]);
        if (row.rate[p] >= 0 && std::isfinite(row.rate[p])) continue;
        throw base::RunError(
            fmt::format("the jump rate of species {} out of voxel {} is {} 1/s; it must be a finite number >= 0",
                        network_.name(species_[d]), i, row.rate[p]));
      }
    }
  }
}

void RateSystem::act_on(Process process) {
  diffusion_ = process != Process::reactions;
  reactions_ = process != Process::diffusion && network_.any_integrated();
}

void RateSystem::spread(const double* y, double* dy) const {
  const std::size_t stride = species_.size();
  for (std::size_t d = 0; d < stride; ++d) {
    if (!rows_[d].graph) continue;
    const std::uint64_t* const first = rows_[d].graph->first.data();
    const std::uint32_t* const target = rows_[d].graph->target.data();
    const double* const rate = rows_[d].rate.data();
    for (std::size_t i = 0; i < voxels_->size(); ++i) {
      const double n = y[i * stride + d];
      if (n == 0.0) continue;
      double out = 0;
      for (std::uint64_t p = first[i]; p < first[i + 1]; ++p) {
        const double flux = rate[p] * n;
        dy[target[p] * stride + d] += flux;
        out += flux;
      }
      dy[i * stride + d] -= out;
    }
  }
}

// `entries`: 1 for the derivative, 0 along a direction.
void RateSystem::exchange(const double* y, double* dy, double entries) const {
  const std::size_t stride = species_.size();
  double* const book = dy + unknowns();
  for (const Exchange& exchange : voxels_->exchanges) {
    const int d = place_of_[exchange.species];
    if (d < 0) continue;
    const std::size_t at = exchange.voxel * stride + d;
    const double in = entries * exchange.entry_rate, out = exchange.exit_rate * y[at];
    dy[at] += in - out;
    book[entered * stride + d] += in;
    book[left * stride + d] += out;
  }
}

void RateSystem::derivative(double t, const double* y, double* dy) {
  std::fill_n(dy, size(), 0.0);
  if (diffusion_) {
    spread(y, dy);
    exchange(y, dy, 1.0);
  }
  if (!reactions_) return;
  for (Expression& expression : laws_.expressions) expression.set_time(t);
  laws_.set_parameters(network_, state_->parameter.data());
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (int r : network_.integrated_in(voxels_->material[i])) {
      add(r, i, rate(laws_.of_reaction[r], r, i, y), dy);
    }
  }
  add_surfaces(y, nullptr, dy);
}

void RateSystem::derivative_along(double t, const double* y, const double* direction, double* out) {
  std::fill_n(out, size(), 0.0);
  if (diffusion_) {
    spread(direction, out);
    exchange(direction, out, 0.0);
  }
  if (!reactions_) return;
  for (Expression& expression : laws_.expressions) expression.set_time(t);
  laws_.set_parameters(network_, state_->parameter.data());
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (int r : network_.integrated_in(voxels_->material[i])) {
      add(r, i, rate_along(laws_.of_reaction[r], r, i, y, direction), out);
    }
  }
  add_surfaces(y, direction, out);
}

void RateSystem::add(const Reaction& reaction, std::size_t voxel, std::size_t partner, double rate, double* dy) const {
  const std::size_t stride = species_.size();
  double* const book = dy + unknowns();
  for (const Change& change : reaction.changes) {
    const int d = place_of_[change.species];
    const double molecules = change.amount * rate;
    dy[(change.beyond ? partner : voxel) * stride + d] += molecules;
    book[(change.amount > 0 ? created : destroyed) * stride + d] += std::abs(change.amount) * rate;
  }
}

// Amounts a little below zero are the integrator's tolerance. One of them turns a reaction round, which lifts it. Two
// would multiply to a rate that drives both down without bound: -1 then, to turn it round as well, else 1.
double RateSystem::turn(const Law& law, std::size_t voxel, const double* y) const {
  int negative = 0;
  for (std::uint32_t f = law.first; f < law.last; ++f) {
    const Factor& factor = laws_.factors[f];
    const int d = place_of_[factor.species];
    if (d >= 0 && y[voxel * species_.size() + d] < 0) negative += factor.count;
  }
  return negative > 0 && negative % 2 == 0 ? -1.0 : 1.0;
}

double RateSystem::frozen(int species, std::size_t voxel) const {
  const std::size_t at = voxel * state_->species + species;
  return network_.stochastic(species) ? static_cast<double>(state_->count[at]) : state_->amount[at];
}

double RateSystem::frozen_factor(const Factor& factor, std::size_t voxel) const {
  if (factor.stochastic) return falling(state_->count[voxel * state_->species + factor.species], factor.count);
  return std::pow(frozen(factor.species, voxel), factor.count);
}

double RateSystem::rate(const Law& law, int reaction, std::size_t voxel, const double* y) {
  if (law.expression >= 0) return expression_rate(law, reaction, voxel, y);
  const double volume = voxels_->volume[voxel];
  double a = turn(law, voxel, y) * law.constant * volume_factor(law.order, volume, 1.0 / volume);
  for (std::uint32_t f = law.first; f < law.last; ++f) {
    const Factor& factor = laws_.factors[f];
    if (place_of_[factor.species] < 0) {
      a *= frozen_factor(factor, voxel);
    } else {
      const double n = y[voxel * species_.size() + place_of_[factor.species]];
      for (int k = 0; k < factor.count; ++k) a *= n;
    }
  }
  return a;
}

double RateSystem::rate_along(const Law& law, int reaction, std::size_t voxel, const double* y,
                              const double* direction) {
  const std::size_t stride = species_.size(), at = voxel * stride;
  if (law.expression < 0) {
    // sum over deterministic factors of nu n^(nu-1) dn times all other factors
    const double volume = voxels_->volume[voxel];
    double product = turn(law, voxel, y) * law.constant * volume_factor(law.order, volume, 1.0 / volume), slope = 0;
    for (std::uint32_t f = law.first; f < law.last; ++f) {
      const Factor& factor = laws_.factors[f];
      if (place_of_[factor.species] < 0) {
        const double n = frozen_factor(factor, voxel);
        product *= n;
        slope *= n;
        continue;
      }
      const double n = y[at + place_of_[factor.species]], dn = direction[at + place_of_[factor.species]];
      for (int k = 0; k < factor.count; ++k) {
        slope = slope * n + product * dn;
        product *= n;
      }
    }
    return slope;
  }
  // A difference along the direction, of a size that shifts amounts by about 1e-7 of their largest.
  double largest = 0, most = 0;
  for (std::size_t d = 0; d < stride; ++d) {
    largest = std::max(largest, std::abs(y[at + d]));
    most = std::max(most, std::abs(direction[at + d]));
  }
  if (most == 0) return 0;
  const double step = 1e-7 * std::max(largest, 1e-6) / most;
  shifted_.resize(unknowns());
  for (std::size_t d = 0; d < stride; ++d) shifted_[at + d] = y[at + d] + step * direction[at + d];
  return (expression_rate(law, reaction, voxel, shifted_.data()) - expression_rate(law, reaction, voxel, y)) / step;
}

double RateSystem::expression_rate(const Law& law, int reaction, std::size_t voxel, const double* y) {
  Expression& expression = laws_.expressions[law.expression];
  const double volume = voxels_->volume[voxel];
  for (int s : expression.reads()) {
    const int d = place_of_[s];
    const double n = d < 0 ? frozen(s, voxel) : std::max(0.0, y[voxel * species_.size() + d]);
    expression.set_concentration(s, n / volume);
  }
  const auto& x = voxels_->position[voxel];
  expression.set_position(x[0], x[1], x[2]);
  const double a = volume * expression.value();
  if (std::isfinite(a)) return a;
  throw base::RunError(
      fmt::format("reaction {} has the rate {} 1/s in voxel {} at t = {} s; it must be a finite number: look at "
                  "its rate law and at the numbers it reads",
                  network_.reactions()[reaction].name, a, voxel, expression.time()));
}

void RateSystem::add_steps(double from, double to, std::vector<double>& moments) {
  if (!reactions_ || laws_.timed.empty()) return;
  laws_.set_parameters(network_, state_->parameter.data());
  for (TimedRate& rate : laws_.timed) rate.common_steps(from, to, moments);
}

void RateSystem::check_signs(double t, double dt, const double* y, double allowed) {
  if (!reactions_ || laws_.expressions.empty()) return;
  for (Expression& expression : laws_.expressions) expression.set_time(t);
  laws_.set_parameters(network_, state_->parameter.data());
  for (std::size_t i = 0; i < voxels_->size(); ++i) {
    for (int r : network_.integrated_in(voxels_->material[i])) {
      const Law& law = laws_.of_reaction[r];
      if (law.expression < 0) continue;
      const double a = expression_rate(law, r, i, y);
      if (a * dt >= -allowed) continue;
      throw base::RunError(
          fmt::format("reaction {} has the rate {} 1/s in voxel {} at t = {} s; a rate must not be negative: "
                      "write what runs backwards as a reaction of its own",
                      network_.reactions()[r].name, a, i, t));
    }
  }
}

}  // namespace shmoo::rdme
